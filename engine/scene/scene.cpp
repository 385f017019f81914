#include "engine/scene/scene.h"

#include <algorithm>

#include "engine/scene/visibility.h"

namespace macula::scene {
namespace {

// A sun from the upper right behind the camera: 3 lux makes a white diffuse surface facing it
// about 0.95, and the ambient term keeps shadows readable.
constexpr float kKeyIntensity = 3.0F;
const glm::vec3 kKeyDirection{-0.45F, -0.8F, -0.4F};
constexpr float kDefaultAmbient = 0.25F;

bool hasLitMaterial(const Scene& scene) {
  return std::any_of(scene.primitives.begin(), scene.primitives.end(),
                     [&](const Primitive& p) { return !scene.materialOf(p).unlit; });
}

template <typename Wanted>
Bounds boundsWhere(const Scene& scene, Wanted wanted) {
  Bounds bounds;
  for (const Instance& instance : scene.instances) {
    const Primitive& primitive = scene.primitives[instance.primitive];
    if (!wanted(primitive)) continue;
    // Through the corners of the primitive's own box: exact enough to frame it, and fast.
    const Bounds world = transformed(boundsOf(primitive), instance.transform);
    if (world.empty()) continue;
    bounds.add(world.min);
    bounds.add(world.max);
  }
  return bounds;
}

}  // namespace

const Material& Scene::materialOf(const Primitive& primitive) const {
  static const Material kDefault;
  if (primitive.material == kNone) return kDefault;
  return materials[static_cast<std::size_t>(primitive.material)];
}

Bounds boundsOf(const Primitive& primitive) {
  Bounds bounds;
  for (const glm::vec3& p : primitive.positions) bounds.add(p);
  return bounds;
}

Bounds boundsOf(const Scene& scene) {
  return boundsWhere(scene, [](const Primitive&) { return true; });
}

Bounds transparentBoundsOf(const Scene& scene) {
  return boundsWhere(scene, [&](const Primitive& primitive) {
    return scene.materialOf(primitive).isTransparent();
  });
}

glm::vec2 distancesTo(const Bounds& bounds, const Camera& camera) {
  if (bounds.empty()) return {camera.nearPlane, camera.farPlane};
  const glm::vec3 nearest = glm::clamp(camera.position, bounds.min, bounds.max);
  float farthest = camera.nearPlane;
  for (unsigned corner = 0; corner < 8; ++corner) {
    farthest = std::max(farthest, glm::distance(camera.position, bounds.corner(corner)));
  }
  return {std::max(camera.nearPlane, glm::distance(camera.position, nearest)), farthest};
}

void addDefaultLights(Scene& scene) {
  if (!hasLitMaterial(scene)) return;
  if (scene.lights.empty()) {
    Light key;
    key.direction = glm::normalize(kKeyDirection);
    key.intensity = kKeyIntensity;
    scene.lights.push_back(key);
    if (scene.ambient == glm::vec3(0.0F)) scene.ambient = glm::vec3(kDefaultAmbient);
  }
  const auto casts = [](const Light& light) { return light.castsShadow; };
  if (std::any_of(scene.lights.begin(), scene.lights.end(), casts)) return;
  for (Light& light : scene.lights) {
    if (light.type == LightType::Directional) {
      light.castsShadow = true;
      return;
    }
  }
}

}  // namespace macula::scene
