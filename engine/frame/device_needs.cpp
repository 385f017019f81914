#include "engine/frame/device_needs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <set>

#include "engine/gl/program_interface.h"
#include "shared/bindings.h"

namespace macula::frame {
namespace {

using gl::Limit;

/// Textures that GpuScene binds for the shading of a surface: its material's, the environment.
constexpr std::int64_t kSceneTextures = MATERIAL_TEXTURES + 1;
/// Texture units up to the highest that GpuScene binds.
constexpr std::int64_t kSceneTextureUnits = TEX_ENVIRONMENT + 1;

/// Units of one kind that a step binds, alternatives counted once.
struct Units {
  std::set<std::uint32_t> units;
  [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(units.size()); }
  [[nodiscard]] std::int64_t end() const { return units.empty() ? 0 : *units.rbegin() + 1; }
};

struct Step {
  Units textures;
  Units images;
  Units storage;
  Units outputs;
  bool draws = false;
};

Step stepOf(const PassDeclaration& table, std::uint32_t number) {
  Step step;
  for (const Binding& row : table.bindings()) {
    if (row.step != number) continue;
    switch (row.point) {
      case BindPoint::Texture:
        step.textures.units.insert(row.unit);
        break;
      case BindPoint::Image:
        step.images.units.insert(row.unit);
        break;
      case BindPoint::Storage:
        step.storage.units.insert(row.unit);
        break;
      case BindPoint::ColorTarget:
        step.outputs.units.insert(row.unit);
        step.draws = true;
        break;
      case BindPoint::DepthTarget:
        step.draws = true;
        break;
      case BindPoint::Indirect:
      case BindPoint::Update:
        break;
    }
  }
  return step;
}

/// Keeps the largest amount of each limit.
class Needs {
 public:
  void raise(Limit limit, std::int64_t amount) {
    std::int64_t& most = most_[static_cast<std::size_t>(limit)];
    most = std::max(most, amount);
  }
  [[nodiscard]] std::vector<Need> finish() const {
    std::vector<Need> needs;
    for (const gl::LimitRow& row : gl::limitRows()) {
      const std::int64_t amount = most_[static_cast<std::size_t>(row.limit)];
      if (amount > 0) needs.push_back({row.limit, amount});
    }
    return needs;
  }

 private:
  std::array<std::int64_t, gl::kLimits> most_{};
};

/// A step with targets may dispatch, too: in a frame in which they rest.
void addStep(Needs& needs, const Step& step, bool scene) {
  const std::int64_t storage = step.storage.count();
  const std::int64_t images = step.images.count();
  const std::int64_t textures = step.textures.count();
  needs.raise(Limit::StorageBindings, step.storage.end());
  needs.raise(Limit::ComputeStorageBlocks, storage);
  needs.raise(Limit::CombinedStorageBlocks, storage);
  needs.raise(Limit::ImageUnits, step.images.end());
  needs.raise(Limit::ComputeImages, images);
  needs.raise(Limit::CombinedImages, images);
  needs.raise(Limit::CombinedOutputs, images + storage + step.outputs.count());
  needs.raise(Limit::ComputeTextures, textures + 1);  // lighting samples the environment
  needs.raise(Limit::TextureUnits, std::max(step.textures.end(), kSceneTextureUnits));
  if (!step.draws) return;
  needs.raise(Limit::FragmentStorageBlocks, storage);
  needs.raise(Limit::FragmentImages, images);
  needs.raise(Limit::FragmentTextures, textures + (scene ? kSceneTextures : 0));
  needs.raise(Limit::ColorAttachments, step.outputs.end());
  needs.raise(Limit::DrawBuffers, step.outputs.end());
}

/// Numbers of one kind of resource by stage, one that two stages use counted twice, as drivers do.
struct Stages {
  std::int64_t vertex = 0;
  std::int64_t fragment = 0;
  std::int64_t compute = 0;
  std::int64_t end = 0;
  [[nodiscard]] std::int64_t sum() const { return vertex + fragment + compute; }
  void add(GLint v, GLint f, GLint c, GLint unit) {
    vertex += v;
    fragment += f;
    compute += c;
    end = std::max<std::int64_t>(end, unit + 1);
  }
};

bool isImage(GLint type) {
  return type >= GL_IMAGE_1D && type <= GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY;
}

/// Samplers of the kinds that the shaders use.
bool isSampler(GLint type) {
  return type == GL_SAMPLER_2D || type == GL_SAMPLER_2D_SHADOW || type == GL_SAMPLER_CUBE ||
         type == GL_UNSIGNED_INT_SAMPLER_2D || type == GL_SAMPLER_2D_MULTISAMPLE ||
         type == GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE;
}

}  // namespace

std::vector<Need> needsOf(const PassDeclaration& table) {
  Needs needs;
  for (std::uint32_t step = 0; step < table.steps(); ++step) {
    addStep(needs, stepOf(table, step), table.drawsScene(step));
  }
  for (const Extent& extent : table.extents()) {
    if (extent.resource->isBuffer()) continue;
    needs.raise(Limit::TextureSide, std::max(extent.size.x, extent.size.y));
  }
  return needs.finish();
}

std::vector<Need> needsOf(GLuint program) {
  Stages storage;
  for (GLuint i = 0; i < gl::resourceCount(program, GL_SHADER_STORAGE_BLOCK); ++i) {
    const auto [unit, vertex, fragment, compute] =
        gl::propertiesOf<4>(program, GL_SHADER_STORAGE_BLOCK, i,
                            {GL_BUFFER_BINDING, GL_REFERENCED_BY_VERTEX_SHADER,
                             GL_REFERENCED_BY_FRAGMENT_SHADER, GL_REFERENCED_BY_COMPUTE_SHADER});
    storage.add(vertex, fragment, compute, unit);
  }
  Stages images;
  Stages textures;
  for (GLuint i = 0; i < gl::resourceCount(program, GL_UNIFORM); ++i) {
    const auto [type, location, vertex, fragment, compute] =
        gl::propertiesOf<5>(program, GL_UNIFORM, i,
                            {GL_TYPE, GL_LOCATION, GL_REFERENCED_BY_VERTEX_SHADER,
                             GL_REFERENCED_BY_FRAGMENT_SHADER, GL_REFERENCED_BY_COMPUTE_SHADER});
    if (!isImage(type) && !isSampler(type)) continue;
    GLint unit = 0;
    glGetUniformiv(program, location, &unit);
    (isImage(type) ? images : textures).add(vertex, fragment, compute, unit);
  }
  std::int64_t outputs = 0;
  std::int64_t outputEnd = 0;
  for (GLuint i = 0; i < gl::resourceCount(program, GL_PROGRAM_OUTPUT); ++i) {
    const auto [location, fragment] = gl::propertiesOf<2>(
        program, GL_PROGRAM_OUTPUT, i, {GL_LOCATION, GL_REFERENCED_BY_FRAGMENT_SHADER});
    if (fragment == 0 || location < 0) continue;  // depth has no location
    ++outputs;
    outputEnd = std::max<std::int64_t>(outputEnd, location + 1);
  }
  Needs needs;
  needs.raise(Limit::StorageBindings, storage.end);
  needs.raise(Limit::VertexStorageBlocks, storage.vertex);
  needs.raise(Limit::FragmentStorageBlocks, storage.fragment);
  needs.raise(Limit::ComputeStorageBlocks, storage.compute);
  needs.raise(Limit::CombinedStorageBlocks, storage.sum());
  needs.raise(Limit::ImageUnits, images.end);
  needs.raise(Limit::FragmentImages, images.fragment);
  needs.raise(Limit::ComputeImages, images.compute);
  needs.raise(Limit::CombinedImages, images.sum());
  needs.raise(Limit::CombinedOutputs, images.sum() + storage.sum() + outputs);
  needs.raise(Limit::FragmentTextures, textures.fragment);
  needs.raise(Limit::ComputeTextures, textures.compute);
  needs.raise(Limit::TextureUnits, textures.end);
  needs.raise(Limit::ColorAttachments, outputEnd);
  needs.raise(Limit::DrawBuffers, outputEnd);
  if (textures.compute + images.compute + storage.compute > 0) {
    std::array<GLint, 3> group{};
    glGetProgramiv(program, GL_COMPUTE_WORK_GROUP_SIZE, group.data());
    needs.raise(Limit::GroupThreads, std::int64_t{group[0]} * group[1] * group[2]);
  }
  return needs.finish();
}

std::string Shortage::describe() const {
  const gl::LimitRow& row = gl::rowOf(need.limit);
  return fmt::format("pass '{}' needs {} {} ({}), and this GPU has {}", pass, need.amount, row.what,
                     row.name, offered);
}

std::optional<Shortage> shortageOf(std::string_view pass, const std::vector<Need>& needs,
                                   const gl::Limits& limits) {
  for (const Need& need : needs) {
    if (need.amount <= limits[need.limit]) continue;
    return Shortage{std::string(pass), need, limits[need.limit]};
  }
  return std::nullopt;
}

}  // namespace macula::frame
