#include "engine/scene/scene_facts.h"

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
      facts.veins = facts.veins || (material.veins.any() && !material.unlit);
    }
  }
  for (const Light& light : scene.lights) {
    if (!light.castsShadow) continue;
    facts.shadowLight = true;
    facts.shadowTaps = light.shadowTaps;
  }
  facts.environment = hasEnvironment;
  facts.occlusion = scene.occlusion;
  return facts;
}

}  // namespace macula::scene
