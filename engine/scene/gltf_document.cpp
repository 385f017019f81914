#include "engine/scene/gltf_document.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/core/plural.h"
#include "engine/scene/gltf_container.h"
#include "engine/scene/gltf_uri.h"

namespace macula::scene::gltf {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 6> kSupportedExtensions = {
    "KHR_lights_punctual",        "KHR_materials_emissive_strength",
    "KHR_materials_transmission", "KHR_materials_unlit",
    "KHR_materials_volume",       "KHR_mesh_quantization"};

// tinygltf copies nested values by recursion; real files nest less than 20 deep.
constexpr int kMaxNesting = 256;
// tinygltf takes the length of the JSON as 32 bits.
constexpr std::size_t kMaxJsonBytes = std::size_t{1} << 31U;

const json* member(const json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::string stringMember(const json& object, const char* key) {
  const json* value = member(object, key);
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

std::int32_t indexMember(const json& object, const char* key) {
  const json* value = member(object, key);
  if (value == nullptr || !value->is_number_integer()) return kNone;
  const auto index = value->get<std::int64_t>();
  return index >= 0 && index <= INT32_MAX ? static_cast<std::int32_t>(index) : INT32_MAX;
}

// The array under `key`; an empty one where there is none.
const json& arrayMember(const json& root, const char* key, const std::string& name) {
  static const json kEmpty = json::array();
  const json* value = member(root, key);
  if (value == nullptr) return kEmpty;
  if (!value->is_array()) failInput("{}: '{}' is not an array; export the file again", name, key);
  return *value;
}

void checkNesting(std::string_view text, const std::string& name) {
  int depth = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inString) {
      if (c == '\\') {
        ++i;
      } else if (c == '"') {
        inString = false;
      }
    } else if (c == '"') {
      inString = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kMaxNesting) {
        failInput("{}: the JSON is nested more than {} deep; export the file again", name,
                  kMaxNesting);
      }
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
}

json parseJson(std::string_view text, const std::string& name) {
  if (text.size() > kMaxJsonBytes) {
    failInput("{}: the JSON is larger than 2 GiB; export the file as .glb", name);
  }
  checkNesting(text, name);
  try {
    return json::parse(text.begin(), text.end());
  } catch (const json::exception& error) {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
    std::string_view reason = error.what();
    reason.remove_prefix(std::min(reason.size(), reason.find(']') + 2));
    failInput("{}: the JSON cannot be read ({}); correct it or export the file again", name,
              reason);
  }
}

void checkAsset(const json& root, const std::string& name) {
  const json* asset = member(root, "asset");
  const std::string version = asset == nullptr ? std::string() : stringMember(*asset, "version");
  if (version.empty()) {
    failInput("{}: asset.version is missing; name a glTF 2.0 file", name);
  }
  if (!version.starts_with("2.")) {
    failInput("{}: asset.version is {}; convert the file to glTF 2.0", name, version);
  }
  const std::string minimum = stringMember(*asset, "minVersion");
  if (!minimum.empty() && minimum != "2.0") {
    failInput("{}: asset.minVersion is {}; export the file as glTF 2.0", name, minimum);
  }
}

void checkRequiredExtensions(const json& root, const std::string& name) {
  std::string missing;
  for (const json& extension : arrayMember(root, "extensionsRequired", name)) {
    const std::string id = extension.is_string() ? extension.get<std::string>() : extension.dump();
    if (isSupportedExtension(id)) continue;
    missing += (missing.empty() ? "" : ", ") + id;
  }
  if (!missing.empty()) {
    failInput("{}: requires {}, which Macula does not draw; export the file without it", name,
              missing);
  }
}

// What tinygltf would drop in silence: primitives that it cannot parse.
void checkMeshes(const json& root, const std::string& name) {
  const json& accessors = arrayMember(root, "accessors", name);
  std::size_t meshIndex = 0;
  for (const json& mesh : arrayMember(root, "meshes", name)) {
    std::size_t primitiveIndex = 0;
    const json* primitives = member(mesh, "primitives");
    if (primitives == nullptr || !primitives->is_array() || primitives->empty()) {
      failInput("{}: mesh {} has no primitives; export the file again", name, meshIndex);
    }
    for (const json& primitive : *primitives) {
      const json* attributes = member(primitive, "attributes");
      if (attributes == nullptr || !attributes->is_object()) {
        failInput("{}: mesh {} primitive {} has no attributes; export the file again", name,
                  meshIndex, primitiveIndex);
      }
      const json* extensions = member(primitive, "extensions");
      const auto position = static_cast<std::size_t>(indexMember(*attributes, "POSITION"));
      if (extensions != nullptr && extensions->contains("KHR_draco_mesh_compression") &&
          position < accessors.size() && member(accessors[position], "bufferView") == nullptr) {
        failInput(
            "{}: mesh {} primitive {} is compressed with KHR_draco_mesh_compression, which "
            "Macula does not read; export the file without it",
            name, meshIndex, primitiveIndex);
      }
      ++primitiveIndex;
    }
    ++meshIndex;
  }
}

void readBuffers(const json& root, std::span<const std::byte> binary, Document& document) {
  const json& buffers = arrayMember(root, "buffers", document.name);
  std::map<std::string, std::size_t> readBefore;  // several buffers may name one file
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const std::string place = fmt::format("buffer {}", i);
    const json* length = member(buffers[i], "byteLength");
    if (length == nullptr || !length->is_number_unsigned() || *length == 0U) {
      document.fail(place, "byteLength is not a positive integer; export the file again");
    }
    const auto byteLength = length->get<std::uint64_t>();
    const json* uri = member(buffers[i], "uri");
    std::span<const std::byte> bytes;
    if (uri != nullptr && uri->is_string()) {
      const std::string& text = uri->get_ref<const std::string&>();
      auto [entry, isNew] = readBefore.try_emplace(text, document.storage.size());
      if (isNew) {
        try {
          document.storage.push_back(readUri(text, document.folder, UINT64_MAX));
        } catch (const InputError& error) {
          document.fail(place, "{}", error.what());
        }
      }
      bytes = document.storage[entry->second];
    } else if (i == 0 && !binary.empty()) {
      bytes = binary;
    } else {
      document.buffers.emplace_back();  // filled by an extension that is not read, or by nobody
      continue;
    }
    if (bytes.size() < byteLength) {
      document.fail(place, "has {} where byteLength asks for {}; copy or export the file again",
                    counted(bytes.size(), "byte"), byteLength);
    }
    document.buffers.push_back(bytes.first(static_cast<std::size_t>(byteLength)));
  }
}

void readImageSources(const json& root, Document& document) {
  for (const json& image : arrayMember(root, "images", document.name)) {
    document.images.push_back({stringMember(image, "name"), stringMember(image, "uri"),
                               indexMember(image, "bufferView")});
  }
}

}  // namespace

void Warnings::add(const std::string& line) {
  if (lines_.size() >= kMaxLines) {
    if (!seen_.contains(line)) ++leftOut_;
    return;
  }
  if (seen_.insert(line).second) lines_.push_back(line);
}

std::vector<std::string> Warnings::lines() const {
  std::vector<std::string> all = lines_;
  if (leftOut_ > 0) all.push_back(counted(leftOut_, "more warning"));
  return all;
}

bool isSupportedExtension(std::string_view extension) {
  return std::find(kSupportedExtensions.begin(), kSupportedExtensions.end(), extension) !=
         kSupportedExtensions.end();
}

std::span<const std::byte> Document::viewBytes(std::int32_t view, std::string_view place) const {
  if (view < 0 || static_cast<std::size_t>(view) >= model.bufferViews.size()) {
    fail(place, "names buffer view {} of {}; export the file again", view,
         model.bufferViews.size());
  }
  const tinygltf::BufferView& entry = model.bufferViews[static_cast<std::size_t>(view)];
  if (entry.buffer < 0 || static_cast<std::size_t>(entry.buffer) >= buffers.size()) {
    fail(place, "buffer view {} names buffer {} of {}; export the file again", view, entry.buffer,
         buffers.size());
  }
  const std::span<const std::byte> buffer = buffers[static_cast<std::size_t>(entry.buffer)];
  if (entry.byteOffset > buffer.size() || entry.byteLength > buffer.size() - entry.byteOffset) {
    fail(place, "buffer view {} reaches beyond the {} bytes of buffer {}; export the file again",
         view, buffer.size(), entry.buffer);
  }
  return buffer.subspan(entry.byteOffset, entry.byteLength);
}

Document openDocument(std::span<const std::byte> bytes, const std::filesystem::path& folder,
                      const std::string& name) {
  const Container container = splitContainer(bytes, name);
  json root = parseJson(container.json, name);
  checkAsset(root, name);
  checkRequiredExtensions(root, name);
  checkMeshes(root, name);

  Document document;
  document.name = name;
  document.folder = folder;
  readBuffers(root, container.binary, document);
  readImageSources(root, document);
  if (const std::size_t count = arrayMember(root, "animations", name).size(); count > 0) {
    document.warnings.add(counted(count, "animation is", "animations are") + " not played");
  }
  // tinygltf 2.7 gets neither bytes to trust nor files to open: it would read images beyond their
  // buffers, expand paths through a shell and stop at the first image it cannot decode.
  for (const char* key : {"buffers", "images", "animations", "extras"}) root.erase(key);
  const std::string text = root.dump(-1, ' ', false, json::error_handler_t::replace);
  root = nullptr;

  tinygltf::TinyGLTF parser;
  std::string errors;
  std::string notes;
  bool parsed = false;
  try {
    parsed = parser.LoadASCIIFromString(&document.model, &errors, &notes, text.c_str(),
                                        static_cast<unsigned>(text.size()), "");
  } catch (const std::exception& error) {
    errors = error.what();
  }
  if (!parsed) {
    while (errors.ends_with('\n') || errors.ends_with('.')) errors.pop_back();
    failInput("{}: {}; correct the file or export it again", name,
              errors.empty() ? "the glTF structure cannot be read" : oneLine(errors));
  }
  return document;
}

}  // namespace macula::scene::gltf
