// tinygltf 2.7 is compiled in this file. Of its reading only the parsers of single objects are
// used, because its loaders of whole files copy the binary chunk once for each buffer that has no
// URI, read images beyond their buffers, refuse empty binary chunks and drop primitives in silence.
#define TINYGLTF_IMPLEMENTATION
#include <fstream>  // which tiny_gltf.h needs and, without its own file access, does not include

#include <string_view>
#include <vector>

#include "engine/scene/gltf_accessors.h"
#include "engine/scene/gltf_document.h"
#include "engine/scene/gltf_json.h"

namespace macula::scene::gltf {
namespace {

/// tinygltf's complaint as the middle of a message.
std::string tidy(const std::string& errors) {
  std::string line = oneLine(errors);
  while (line.ends_with('.') || line.ends_with(' ')) line.pop_back();
  return line.empty() ? "cannot be read" : line;
}

/// A mesh none of whose primitives tinygltf has dropped.
bool parseMesh(tinygltf::Mesh* mesh, std::string* errors, const Json& value, bool keepJson) {
  // The parser of primitives uses the model for Draco alone, which is not compiled in.
  if (!tinygltf::ParseMesh(mesh, nullptr, errors, value, keepJson)) return false;
  const Json* primitives = member(value, "primitives");
  if (primitives == nullptr || !primitives->is_array() || primitives->empty()) {
    *errors = "has no primitives";
    return false;
  }
  return mesh->primitives.size() == primitives->size();
}

bool parseTexture(tinygltf::Texture* texture, std::string* errors, const Json& value,
                  bool keepJson) {
  return tinygltf::ParseTexture(texture, errors, value, keepJson, "");
}

bool parseScene(tinygltf::Scene* scene, std::string* errors, const Json& value, bool /*keepJson*/) {
  tinygltf::ParseIntegerArrayProperty(&scene->nodes, errors, value, "nodes", false);
  tinygltf::ParseExtrasProperty(&scene->extras, value);
  return true;
}

class ModelReader {
 public:
  ModelReader(const Json& root, Document& document) : root_(root), document_(document) {}

  void read() {
    tinygltf::Model& model = document_.model;
    for (const Json& extension : arrayMember(root_, "extensionsUsed", document_.name)) {
      if (extension.is_string()) model.extensionsUsed.push_back(extension.get<std::string>());
    }
    readList(root_, "bufferViews", "buffer view", model.bufferViews, tinygltf::ParseBufferView);
    readList(root_, "accessors", "accessor", model.accessors, tinygltf::ParseAccessor);
    readList(root_, "meshes", "mesh", model.meshes, parseMesh);
    readList(root_, "nodes", "node", model.nodes, tinygltf::ParseNode);
    readList(root_, "scenes", "scene", model.scenes, parseScene);
    readList(root_, "materials", "material", model.materials, tinygltf::ParseMaterial);
    readList(root_, "textures", "texture", model.textures, parseTexture);
    readList(root_, "samplers", "sampler", model.samplers, tinygltf::ParseSampler);
    readList(root_, "skins", "skin", model.skins, tinygltf::ParseSkin);
    readList(root_, "cameras", "camera", model.cameras, tinygltf::ParseCamera);
    if (const Json* extensions = member(root_, "extensions")) {
      if (const Json* punctual = member(*extensions, "KHR_lights_punctual")) {
        readList(*punctual, "lights", "light", model.lights, tinygltf::ParseLight);
      }
    }
    model.defaultScene = indexMember(root_, "scene");
  }

 private:
  /// @param parse like tinygltf's: from an object; false, and errors, where it cannot be read
  template <typename Object, typename Parse>
  void readList(const Json& owner, const char* key, const char* noun, std::vector<Object>& objects,
                const Parse& parse) {
    for (const Json& value : arrayMember(owner, key, document_.name)) {
      const std::string place = fmt::format("{} {}", noun, objects.size());
      if (!value.is_object()) document_.fail(place, "is no JSON object; export the file again");
      constexpr bool kKeepJson = false;
      std::string errors;
      if (!parse(&objects.emplace_back(), &errors, value, kKeepJson)) {
        document_.fail(place, "{}; correct the file or export it again", tidy(errors));
      }
    }
  }

  const Json& root_;
  Document& document_;
};

/// Whether the vertices of a primitive stand in the file only as Draco's bytes, which are not read.
bool needsDraco(const Document& document, const tinygltf::Primitive& primitive,
                std::string_view place) {
  const auto position = primitive.attributes.find("POSITION");
  return primitive.extensions.contains("KHR_draco_mesh_compression") &&
         position != primitive.attributes.end() &&
         accessorAt(document, position->second, place).bufferView == kNone;
}

/// Checks what would make even a mesh that is not drawn malformed.
void checkMeshes(const Document& document) {
  for (std::size_t m = 0; m < document.model.meshes.size(); ++m) {
    const std::vector<tinygltf::Primitive>& primitives = document.model.meshes[m].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const tinygltf::Primitive& primitive = primitives[i];
      const std::string place = fmt::format("mesh {} primitive {}", m, i);
      if (needsDraco(document, primitive, place)) {
        document.fail(place,
                      "is compressed with KHR_draco_mesh_compression, which Macula does not read; "
                      "export the file without it");
      }
      if (primitive.indices == kNone) continue;
      const tinygltf::Accessor& indices = accessorAt(document, primitive.indices, place);
      static_cast<void>(document.viewBytes(indices.bufferView, place));
    }
  }
}

}  // namespace

void readModel(const Json& root, Document& document) {
  ModelReader(root, document).read();
  checkMeshes(document);
}

}  // namespace macula::scene::gltf
