#include "engine/scene/gltf_loader.h"

#include <algorithm>
#include <new>
#include <stdexcept>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/scene/gltf_container.h"
#include "engine/scene/gltf_document.h"
#include "engine/scene/gltf_extras.h"
#include "engine/scene/gltf_json.h"
#include "engine/scene/gltf_materials.h"
#include "engine/scene/gltf_meshes.h"
#include "engine/scene/gltf_nodes.h"
#include "engine/scene/gltf_uri.h"

namespace macula::scene {
namespace {

void noteExtensions(const gltf::Document& document, Scene& scene) {
  for (const std::string& extension : document.model.extensionsUsed) {
    if (gltf::isSupportedExtension(extension)) continue;
    auto& unsupported = scene.unsupportedExtensions;
    if (std::find(unsupported.begin(), unsupported.end(), extension) == unsupported.end()) {
      unsupported.push_back(oneLine(extension));
    }
  }
}

void addInstances(gltf::Document& document, const gltf::NodeTree& tree, const GltfLimits& limits,
                  Scene& scene) {
  gltf::MeshReader meshes(document, tree, limits, scene);
  for (const std::int32_t index : tree.drawn) {
    const tinygltf::Node& node = document.model.nodes[static_cast<std::size_t>(index)];
    if (node.mesh == kNone) continue;
    // A skinned mesh stands where its joints are; the node's own transform does not count.
    const bool skinned = meshes.isSkinned(node.mesh, node.skin);
    if (node.skin != kNone && !skinned) {
      document.warn(fmt::format("node {}", index), "its mesh has no joints, the skin is left out");
    }
    const auto range = meshes.read(node.mesh, skinned ? node.skin : kNone);
    if (scene.instances.size() + range.count > limits.instances) {
      document.fail(fmt::format("node {}", index), "more than {} draws; split the file",
                    limits.instances);
    }
    const glm::mat4 world = skinned ? glm::mat4(1.0F) : tree.world[static_cast<std::size_t>(index)];
    for (std::uint32_t i = 0; i < range.count; ++i) {
      scene.instances.push_back({range.first + i, world});
    }
  }
}

}  // namespace

Scene loadGltfFromMemory(std::span<const std::byte> bytes, const std::filesystem::path& baseFolder,
                         const std::string& displayName, const GltfLimits& limits) try {
  gltf::Document document = gltf::openDocument(bytes, baseFolder, displayName);
  Scene scene;
  scene.name = displayName;
  noteExtensions(document, scene);
  gltf::readMaterials(document, limits, scene);
  for (const std::string& extension : scene.unsupportedExtensions) {
    document.warnings.add(fmt::format("the optional extension {} is not drawn", extension));
  }
  const gltf::NodeTree tree = gltf::placeNodes(document);
  addInstances(document, tree, limits, scene);
  gltf::addLights(document, tree, scene);
  gltf::addCameras(document, tree, scene);
  scene.ambient = gltf::ambientOf(document);
  scene.occlusion = gltf::occlusionOf(document);
  if (scene.instances.empty()) document.warnings.add("the scene holds no triangles");
  scene.warnings = document.warnings.lines();
  return scene;
} catch (const std::bad_alloc&) {
  failInput("{}: does not fit into memory; split the file", displayName);
} catch (const std::length_error&) {  // of a container asked for more than it can hold
  failInput("{}: does not fit into memory; split the file", displayName);
}

Scene loadGltf(const std::filesystem::path& file, const GltfLimits& limits) {
  std::error_code error;
  if (std::filesystem::exists(file, error) && !std::filesystem::is_directory(file, error) &&
      !std::filesystem::is_regular_file(file, error)) {
    failInput("{}: is no regular file; name a .gltf or .glb file", file.string());
  }
  const std::string bytes = readTextFile(file);
  // An empty folder would mean "none"; a bare file name lies in the current one.
  const std::filesystem::path folder =
      file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  Scene scene = loadGltfFromMemory(std::as_bytes(std::span(bytes)), folder, file.string(), limits);
  scene.name = file.stem().string();
  return scene;
}

std::vector<std::filesystem::path> referencedFiles(const std::filesystem::path& file) {
  const std::string bytes = readTextFile(file);
  const std::string name = file.string();
  std::vector<std::filesystem::path> files;
  try {
    const gltf::Container container = gltf::splitContainer(std::as_bytes(std::span(bytes)), name);
    const gltf::Json root = gltf::parseJson(container.json, name);
    for (const char* list : {"buffers", "images"}) {
      for (const gltf::Json& entry : gltf::arrayMember(root, list, name)) {
        const std::string uri = gltf::stringMember(entry, "uri");
        if (uri.empty() || uri.starts_with("data:")) continue;
        const std::filesystem::path path = gltf::percentDecode(uri);
        if (std::ranges::find(files, path) == files.end()) files.push_back(path);
      }
    }
  } catch (const InputError&) {  // no glTF: loading it says why
    files.clear();
  }
  return files;
}

}  // namespace macula::scene
