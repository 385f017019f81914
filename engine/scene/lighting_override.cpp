#include "engine/scene/lighting_override.h"

#include <glm/glm.hpp>
#include <vector>

namespace macula::scene {
namespace {

// What lights an unlit material, once it has to be lit: matt, because its colours are painted.
constexpr float kPaintRoughness = 0.9F;

// Together they light a white diffuse surface to between 0.3 and 1.2, whichever way it faces. Lamps
// are given by their illuminance in lux at one radius of the scene's bounds; places are in radii
// from the middle.
constexpr float kAmbient = 0.18F;
constexpr float kSunLux = 2.4F;
const glm::vec3 kSunDirection{-0.45F, -0.8F, -0.4F};
constexpr float kSpotOuterAngle = 0.6F;  // radians: wide enough for all of the bounds
constexpr float kSpotInnerAngle = 0.35F;

struct Lamp {
  LightType type;
  glm::vec3 place;
  glm::vec3 color;
  float lux;
};
const Lamp kLamps[] = {
    {LightType::Point, {-0.8F, 0.5F, 0.7F}, {0.62F, 0.76F, 1.0F}, 0.9F},
    {LightType::Point, {0.8F, 0.3F, -0.6F}, {1.0F, 0.70F, 0.42F}, 0.9F},
    {LightType::Spot, {0.2F, 1.5F, 0.5F}, {1.0F, 0.97F, 0.92F}, 2.0F},
};

std::vector<Light> fourLights(const Bounds& bounds) {
  Light sun;
  sun.direction = glm::normalize(kSunDirection);
  sun.intensity = kSunLux;
  sun.castsShadow = true;
  std::vector<Light> lights{sun};
  const float radius = bounds.radius();
  for (const Lamp& lamp : kLamps) {
    Light light;
    light.type = lamp.type;
    light.color = lamp.color;
    light.intensity = lamp.lux * radius * radius;  // candela = lux times distance squared
    light.position = bounds.center() + radius * lamp.place;
    light.direction = -glm::normalize(lamp.place);
    light.innerConeAngle = kSpotInnerAngle;
    light.outerConeAngle = kSpotOuterAngle;
    lights.push_back(light);
  }
  return lights;
}

}  // namespace

void overrideLighting(Scene& scene, LightingOverride lighting) {
  if (lighting == LightingOverride::Own) return;
  for (Material& material : scene.materials) {
    if (!material.isTransparent()) continue;
    if (lighting == LightingOverride::Unlit) {
      material.unlit = true;
    } else if (material.unlit) {
      material.unlit = false;
      material.metallic = 0.0F;
      material.roughness = kPaintRoughness;
      material.metallicRoughnessTexture = {};
    }
  }
  if (lighting == LightingOverride::Four) {
    scene.lights = fourLights(boundsOf(scene));
    scene.ambient = glm::vec3(kAmbient);
  }
}

}  // namespace macula::scene
