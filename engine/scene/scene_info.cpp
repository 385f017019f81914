#include "engine/scene/scene_info.h"

#include <nlohmann/json.hpp>

namespace macula::scene {

SceneInfo describe(const Scene& scene) {
  SceneInfo info;
  for (const Instance& instance : scene.instances) {
    const Primitive& primitive = scene.primitives[instance.primitive];
    const Material& material = scene.materialOf(primitive);
    const std::uint64_t triangles = primitive.indices.size() / 3;
    info.triangles += triangles;
    if (material.alphaMode == AlphaMode::Mask) info.maskTriangles += triangles;
    if (material.alphaMode == AlphaMode::Blend) info.blendTriangles += triangles;
    if (material.transmission > 0.0F) info.transmissionTriangles += triangles;
    if (material.isTransparent()) info.transparentTriangles += triangles;
  }
  info.draws = scene.instances.size();
  for (const Material& material : scene.materials) {
    switch (material.alphaMode) {
      case AlphaMode::Opaque:
        ++info.materials.opaque;
        break;
      case AlphaMode::Mask:
        ++info.materials.mask;
        break;
      case AlphaMode::Blend:
        ++info.materials.blend;
        break;
    }
  }
  info.lights = static_cast<int>(scene.lights.size());
  info.textures = static_cast<int>(scene.images.size());
  info.unsupportedExtensions = scene.unsupportedExtensions;
  info.warnings = scene.warnings;
  return info;
}

nlohmann::ordered_json toJson(const SceneInfo& info) {
  return {{"triangles", info.triangles},
          {"draws", info.draws},
          {"materials",
           {{"opaque", info.materials.opaque},
            {"mask", info.materials.mask},
            {"blend", info.materials.blend}}},
          {"transparent_triangles", info.transparentTriangles},
          {"lights", info.lights},
          {"textures", info.textures},
          {"extensions_unsupported", info.unsupportedExtensions},
          {"warnings", info.warnings}};
}

}  // namespace macula::scene
