#include "engine/frame/binding_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/gl/program_interface.h"
#include "shared/bindings.h"

namespace macula::frame {
namespace {

enum class Kind : std::uint8_t { Sampler, Image, Value, Unknown };

/// What follows from the type of a uniform or an output for the texture behind it.
struct TypeInfo {
  GLenum type;
  Kind kind;
  bool integer;
  bool multisample;
};

constexpr std::array kTypes{
    TypeInfo{GL_SAMPLER_2D, Kind::Sampler, false, false},
    TypeInfo{GL_SAMPLER_2D_SHADOW, Kind::Sampler, false, false},
    TypeInfo{GL_UNSIGNED_INT_SAMPLER_2D, Kind::Sampler, true, false},
    TypeInfo{GL_SAMPLER_2D_MULTISAMPLE, Kind::Sampler, false, true},
    TypeInfo{GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE, Kind::Sampler, true, true},
    TypeInfo{GL_IMAGE_2D, Kind::Image, false, false},
    TypeInfo{GL_UNSIGNED_INT_IMAGE_2D, Kind::Image, true, false},
    TypeInfo{GL_FLOAT, Kind::Value, false, false},
    TypeInfo{GL_FLOAT_VEC2, Kind::Value, false, false},
    TypeInfo{GL_FLOAT_VEC3, Kind::Value, false, false},
    TypeInfo{GL_FLOAT_VEC4, Kind::Value, false, false},
    TypeInfo{GL_FLOAT_MAT4, Kind::Value, false, false},
    TypeInfo{GL_INT, Kind::Value, false, false},
    TypeInfo{GL_INT_VEC2, Kind::Value, false, false},
    TypeInfo{GL_UNSIGNED_INT, Kind::Value, true, false},
    TypeInfo{GL_UNSIGNED_INT_VEC2, Kind::Value, true, false},
    TypeInfo{GL_UNSIGNED_INT_VEC3, Kind::Value, true, false},
    TypeInfo{GL_UNSIGNED_INT_VEC4, Kind::Value, true, false},
};

/// Types that are not listed, such as samplers of cube maps, count as textures that no resource is.
TypeInfo infoOf(GLenum type) {
  const auto* const found = std::find_if(kTypes.begin(), kTypes.end(),
                                         [&](const TypeInfo& info) { return info.type == type; });
  return found != kTypes.end() ? *found : TypeInfo{type, Kind::Unknown, false, false};
}

bool isInteger(GLenum format) {
  return format == GL_R32UI || format == GL_RG32UI || format == GL_RGBA32UI;
}

std::string nameOf(GLuint program, GLenum interface, GLuint index) {
  constexpr GLsizei kLongest = 128;
  std::array<GLchar, kLongest> name{};
  glGetProgramResourceName(program, interface, index, kLongest, nullptr, name.data());
  return name.data();
}

bool isSceneTexture(std::uint32_t unit) {
  static_assert(TEX_BASE_COLOR == 0);
  return unit < MATERIAL_TEXTURES || unit == TEX_ENVIRONMENT;
}

void addTextures(std::vector<ShaderBinding>& all, GLuint program) {
  for (GLuint i = 0; i < gl::resourceCount(program, GL_UNIFORM); ++i) {
    const auto [type, location, length] =
        gl::propertiesOf<3>(program, GL_UNIFORM, i, {GL_TYPE, GL_LOCATION, GL_ARRAY_SIZE});
    const Kind kind = infoOf(static_cast<GLenum>(type)).kind;
    if (kind == Kind::Value) continue;
    const bool image = kind == Kind::Image;
    for (GLint element = 0; element < length; ++element) {
      GLint unit = 0;
      glGetUniformiv(program, location + element, &unit);
      const auto at = static_cast<std::uint32_t>(unit);
      if (!image && isSceneTexture(at)) continue;
      all.push_back({image ? BindPoint::Image : BindPoint::Texture, at, static_cast<GLenum>(type),
                     0, nameOf(program, GL_UNIFORM, i)});
    }
  }
}

void addStorage(std::vector<ShaderBinding>& all, GLuint program) {
  for (GLuint i = 0; i < gl::resourceCount(program, GL_SHADER_STORAGE_BLOCK); ++i) {
    const auto [unit, bytes] = gl::propertiesOf<2>(program, GL_SHADER_STORAGE_BLOCK, i,
                                                   {GL_BUFFER_BINDING, GL_BUFFER_DATA_SIZE});
    all.push_back({BindPoint::Storage, static_cast<std::uint32_t>(unit), 0,
                   static_cast<std::size_t>(bytes), nameOf(program, GL_SHADER_STORAGE_BLOCK, i)});
  }
}

void addOutputs(std::vector<ShaderBinding>& all, GLuint program) {
  for (GLuint i = 0; i < gl::resourceCount(program, GL_PROGRAM_OUTPUT); ++i) {
    const auto [type, location, fragment] = gl::propertiesOf<3>(
        program, GL_PROGRAM_OUTPUT, i, {GL_TYPE, GL_LOCATION, GL_REFERENCED_BY_FRAGMENT_SHADER});
    if (fragment == 0 || location < 0) continue;  // depth has no location
    all.push_back({BindPoint::ColorTarget, static_cast<std::uint32_t>(location),
                   static_cast<GLenum>(type), 0, nameOf(program, GL_PROGRAM_OUTPUT, i)});
  }
}

std::string_view nameOf(BindPoint point) {
  switch (point) {
    case BindPoint::Texture:
      return "texture unit";
    case BindPoint::Image:
      return "image unit";
    case BindPoint::Storage:
      return "storage binding";
    case BindPoint::ColorTarget:
      return "output";
    case BindPoint::Indirect:
    case BindPoint::DepthTarget:
    case BindPoint::Update:
      break;
  }
  return "";
}

bool isSeenByShaders(BindPoint point) {
  return !nameOf(point).empty();
}

bool meets(const Binding& row, const ShaderBinding& used) {
  return row.point == used.point && row.unit == used.unit;
}

Kind kindAt(BindPoint point) {
  if (point == BindPoint::ColorTarget) return Kind::Value;
  return point == BindPoint::Image ? Kind::Image : Kind::Sampler;
}

/// Whether a texture is what a sampler, an image or an output takes it for.
bool fits(const Resource& r, const ShaderBinding& used) {
  if (used.point == BindPoint::Storage) return r.isBuffer();
  const TypeInfo info = infoOf(used.type);
  if (r.isBuffer() || info.kind != kindAt(used.point) || info.integer != isInteger(r.format)) {
    return false;
  }
  // Of a multisample target an output writes one value.
  return used.point == BindPoint::ColorTarget ||
         info.multisample == (r.size == SizeRule::DisplaySamples);
}

/// Drivers state the size of a block in whole vectors; an array of fewer elements is no mistake.
std::size_t roundedUp(std::size_t bytes) {
  constexpr std::size_t kVector = 16;
  return (bytes + kVector - 1) / kVector * kVector;
}

/// Bytes that the table states of a buffer; none where another pass states them.
std::size_t statedBytes(const PassDeclaration& table, const Resource& r) {
  for (const Extent& extent : table.extents()) {
    if (*extent.resource == r) return extent.bytes;
  }
  return 0;
}

/// Visits what programs bind, and remembers which rows that accounts for.
class Comparison {
 public:
  Comparison(std::string_view pass, const PassDeclaration& table)
      : pass_(pass), table_(table), used_(table.bindings().size(), false) {}

  /// Rows of one unit may be alternatives, of which other programs use the others.
  void visit(const ShaderBinding& used) {
    const std::vector<Binding>& rows = table_.bindings();
    const Resource* misfit = nullptr;
    bool fitting = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!meets(rows[i], used)) continue;
      const Resource& r = *rows[i].resource;
      if (!fits(r, used)) {
        misfit = &r;
        continue;
      }
      fitting = true;
      used_[i] = true;
      const std::size_t bytes = statedBytes(table_, r);
      if (bytes > 0 && roundedUp(bytes) < used.bytes) {
        report("{} has {} bytes and block {} needs {}", r.name, bytes, used.name, used.bytes);
      }
    }
    if (fitting) return;
    if (misfit != nullptr) {
      report("{} at {} {} is not what {} takes it for", misfit->name, nameOf(used.point), used.unit,
             used.name);
    } else {
      report("a shader uses {} at {} {}, and no row binds it", used.name, nameOf(used.point),
             used.unit);
    }
  }

  std::vector<std::string> finish() {
    const std::vector<Binding>& rows = table_.bindings();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (used_[i] || !isSeenByShaders(rows[i].point)) continue;
      report("{} is bound at {} {}, and no shader uses it", rows[i].resource->name,
             nameOf(rows[i].point), rows[i].unit);
    }
    return std::move(problems_);
  }

 private:
  template <typename... Args>
  void report(fmt::format_string<Args...> format, Args&&... args) {
    const std::string what = fmt::format(format, std::forward<Args>(args)...);
    std::string line = fmt::format("pass '{}': {}", pass_, what);
    if (std::find(problems_.begin(), problems_.end(), line) == problems_.end()) {
      problems_.push_back(std::move(line));
    }
  }

  std::string_view pass_;
  const PassDeclaration& table_;
  std::vector<bool> used_;  ///< by row
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<ShaderBinding> bindingsOf(GLuint program) {
  std::vector<ShaderBinding> all;
  addTextures(all, program);
  addStorage(all, program);
  addOutputs(all, program);
  return all;
}

std::vector<std::string> compareBindings(std::string_view pass, const PassDeclaration& table,
                                         std::span<const std::vector<ShaderBinding>> programs) {
  Comparison comparison(pass, table);
  for (const std::vector<ShaderBinding>& program : programs) {
    for (const ShaderBinding& used : program) comparison.visit(used);
  }
  return comparison.finish();
}

}  // namespace macula::frame
