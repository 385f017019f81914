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
  facts.lights = scene.lights.size();
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    if (i < facts.lightTypes.size()) facts.lightTypes[i] = light.type;
    if (!light.castsShadow) continue;
    facts.shadowLight = true;
    facts.shadowLightNumber = i;
    facts.shadowTaps = light.shadowTaps;
  }
  facts.environment = hasEnvironment;
  facts.occlusion = scene.occlusion;
  return facts;
}

}  // namespace macula::scene
