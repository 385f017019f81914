#include "engine/scene/gltf_document.h"

#include <algorithm>
#include <array>
#include <map>

#include "engine/core/plural.h"
#include "engine/scene/gltf_container.h"
#include "engine/scene/gltf_json.h"
#include "engine/scene/gltf_uri.h"

namespace macula::scene::gltf {
namespace {

constexpr std::array<std::string_view, 6> kSupportedExtensions = {
    "KHR_lights_punctual",        "KHR_materials_emissive_strength",
    "KHR_materials_transmission", "KHR_materials_unlit",
    "KHR_materials_volume",       "KHR_mesh_quantization"};

void checkAsset(const Json& root, const std::string& name) {
  const Json* asset = member(root, "asset");
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

void checkRequiredExtensions(const Json& root, const std::string& name) {
  std::string missing;
  for (const Json& extension : arrayMember(root, "extensionsRequired", name)) {
    const std::string id = extension.is_string() ? extension.get<std::string>() : extension.dump();
    if (isSupportedExtension(id)) continue;
    missing += (missing.empty() ? "" : ", ") + id;
  }
  if (!missing.empty()) {
    failInput("{}: requires {}, which Macula does not draw; export the file without it", name,
              missing);
  }
}

void readBuffers(const Json& root, std::span<const std::byte> binary, Document& document) {
  const Json& buffers = arrayMember(root, "buffers", document.name);
  std::map<std::string, std::size_t> readBefore;  // several buffers may name one file
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const std::string place = fmt::format("buffer {}", i);
    const Json* length = member(buffers[i], "byteLength");
    if (length == nullptr || !length->is_number_unsigned() || *length == 0U) {
      document.fail(place, "byteLength is not a positive integer; export the file again");
    }
    const auto byteLength = length->get<std::uint64_t>();
    const Json* uri = member(buffers[i], "uri");
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

void readImageSources(const Json& root, Document& document) {
  for (const Json& image : arrayMember(root, "images", document.name)) {
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
  const Json root = parseJson(container.json, name);
  checkAsset(root, name);
  checkRequiredExtensions(root, name);

  Document document;
  document.name = name;
  document.folder = folder;
  readBuffers(root, container.binary, document);
  readImageSources(root, document);
  if (const std::size_t count = arrayMember(root, "animations", name).size(); count > 0) {
    document.warnings.add(counted(count, "animation is", "animations are") + " not played");
  }
  readModel(root, document);
  return document;
}

}  // namespace macula::scene::gltf
