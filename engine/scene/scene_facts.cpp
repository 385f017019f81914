#include "engine/scene/scene_facts.h"

#include "engine/scene/alpha_holes.h"

namespace macula::scene {

SceneFacts factsOf(const Scene& scene, bool hasEnvironment) {
  SceneFacts facts;
  const std::vector<AlphaHoles> holes = alphaHolesOf(scene);
  for (const Instance& instance : scene.instances) {
    const Primitive& primitive = scene.primitives[instance.primitive];
    const Material& material = scene.materialOf(primitive);
    const std::uint64_t triangles = primitive.indices.size() / 3;
    if (triangles == 0 || holes[instance.primitive] == AlphaHoles::All) continue;
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
