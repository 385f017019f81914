#include "engine/scene/scene_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/scene/gltf_container.h"
#include "engine/scene/gltf_uri.h"

namespace macula::scene {
namespace {

using nlohmann::json;

json documentOf(const std::string& bytes, const std::string& name) {
  try {
    const auto container = gltf::splitContainer(std::as_bytes(std::span(bytes)), name);
    return json::parse(container.json, nullptr, false);
  } catch (const InputError&) {
    return json(json::value_t::discarded);
  }
}

}  // namespace

std::vector<std::filesystem::path> referencedFiles(const std::filesystem::path& file) {
  const json document = documentOf(readTextFile(file), file.string());
  std::vector<std::filesystem::path> files;
  if (!document.is_object()) return files;
  for (const char* list : {"buffers", "images"}) {
    const auto entries = document.find(list);
    if (entries == document.end() || !entries->is_array()) continue;
    for (const json& entry : *entries) {
      const auto uri = entry.is_object() ? entry.find("uri") : entry.end();
      if (uri == entry.end() || !uri->is_string()) continue;
      const auto& text = uri->get_ref<const std::string&>();
      if (text.starts_with("data:")) continue;
      const std::filesystem::path path = gltf::percentDecode(text);
      if (std::ranges::find(files, path) == files.end()) files.push_back(path);
    }
  }
  return files;
}

}  // namespace macula::scene
