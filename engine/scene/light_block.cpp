#include "engine/scene/light_block.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace macula::scene {
namespace {

static_assert(kMostVeins == MAX_VEINS && kMostLights == MAX_LIGHTS);

/// A light on a surface is this far away at the least: 1 cm, and less where the scene is small.
constexpr float kLeastLightDistance = 0.01F;  // metres
constexpr float kLeastLightRadii = 1e-3F;     // radii of the scene

}  // namespace

shader::LightData dataOf(const Light& light) {
  shader::LightData d{};
  const auto type = static_cast<float>(light.type);
  d.position = glm::vec4(light.position, type);
  d.direction = glm::vec4(light.direction, light.range);
  d.color = glm::vec4(light.color * light.intensity, light.castsShadow ? 1.0F : 0.0F);
  // KHR_lights_punctual, "Inner and Outer Cone Angles"; 0.001 keeps equal angles from dividing by
  // 0.
  const float cosOuter = std::cos(light.outerConeAngle);
  d.cone.x = 1.0F / std::max(0.001F, std::cos(light.innerConeAngle) - cosOuter);
  d.cone.y = -cosOuter * d.cone.x;
  return d;
}

shader::LightBlock lightBlockOf(const Scene& scene, const Bounds& bounds,
                                const Environment* environment) {
  shader::LightBlock block{};
  const std::size_t count = std::min<std::size_t>(scene.lights.size(), MAX_LIGHTS);
  block.ambient = glm::vec4(scene.ambient, static_cast<float>(count));
  for (std::size_t i = 0; i < count; ++i) block.lights[i] = dataOf(scene.lights[i]);
  if (std::any_of(scene.lights.begin(), scene.lights.end(),
                  [](const Light& light) { return light.castsShadow; })) {
    const glm::mat4 toTexture = glm::scale(glm::translate(glm::mat4(1.0F), {0.5F, 0.5F, 0.0F}),
                                           glm::vec3(0.5F, 0.5F, 1.0F));
    block.shadowMatrix = toTexture * shadowViewProjectionOf(scene, bounds);
    block.shadow.x = 2.0F * bounds.radius();  // world width of the map; the shader knows its size
  }
  const float least = std::min(kLeastLightDistance, kLeastLightRadii * bounds.radius());
  block.shadow.y = least * least;
  block.occlusion =
      glm::vec4(scene.occlusion.radius, static_cast<float>(scene.occlusion.samples), 0.0F, 0.0F);
  const std::vector<std::int32_t> veins = veinNumbers(scene);
  for (std::size_t i = 0; i < veins.size(); ++i) {
    if (veins[i] == kNone) continue;
    const Veins& v = scene.materials[i].veins;
    block.veins[veins[i]] = glm::vec4(v.color, v.scale);
  }
  if (environment == nullptr) return block;
  block.environment = glm::vec4(static_cast<float>(environment->levels.size()), 1.0F, 0.0F, 0.0F);
  for (std::size_t i = 0; i < environment->irradiance.size(); ++i) {
    block.irradiance[i] = glm::vec4(environment->irradiance[i], 0.0F);
  }
  return block;
}

glm::mat4 shadowViewProjectionOf(const Scene& scene, const Bounds& bounds) {
  const auto light = std::find_if(scene.lights.begin(), scene.lights.end(),
                                  [](const Light& l) { return l.castsShadow; });
  if (light == scene.lights.end()) return glm::mat4(1.0F);
  // Any size is drawn; without one the projection would have no inverse.
  const float radius = bounds.radius() > 0.0F ? bounds.radius() : 1.0F;
  const glm::vec3 center = bounds.center();
  const glm::vec3 up =
      std::abs(light->direction.y) > 0.99F ? glm::vec3(1.0F, 0.0F, 0.0F) : glm::vec3(0, 1, 0);
  const glm::mat4 view = glm::lookAt(center - light->direction * radius, center, up);
  return glm::orthoRH_ZO(-radius, radius, -radius, radius, 0.0F, 2.0F * radius) * view;
}

std::vector<std::int32_t> veinNumbers(const Scene& scene) {
  std::vector<std::int32_t> numbers;
  std::int32_t next = 0;
  for (const Material& material : scene.materials) {
    const bool has = material.veins.any() && !material.unlit && next < MAX_VEINS;
    numbers.push_back(has ? next++ : kNone);
  }
  return numbers;
}

}  // namespace macula::scene
