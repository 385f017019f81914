#include "engine/scene/scene_facts.h"

#include <algorithm>

namespace macula::scene {

SceneFacts factsOf(const Scene& scene, bool hasEnvironment) {
  SceneFacts facts;
  for (const Instance& instance : scene.instances) {
    const Primitive& primitive = scene.primitives[instance.primitive];
    const Material& material = scene.materialOf(primitive);
    const std::uint64_t triangles = primitive.indices.size() / 3;
    if (triangles == 0) continue;
    if (material.isTransparent()) {
      facts.transparentTriangles += triangles;
      facts.litTransparent = facts.litTransparent || !material.unlit;
    } else {
      facts.opaqueTriangles += triangles;
      facts.litOpaque = facts.litOpaque || !material.unlit;
      facts.unlitOpaque = facts.unlitOpaque || material.unlit;
    }
  }
  facts.shadowLight = std::any_of(scene.lights.begin(), scene.lights.end(),
                                  [](const Light& light) { return light.castsShadow; });
  facts.environment = hasEnvironment;
  return facts;
}

}  // namespace macula::scene
