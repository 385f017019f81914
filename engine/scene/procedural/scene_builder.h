// Builds a scene from materials, shapes and placements.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene {

/// Shapes that are placed together, for example the wood and the cushion of a bench.
using Model = std::vector<std::uint32_t>;

/// Collects a scene; indices are those of the finished scene.
class SceneBuilder {
 public:
  explicit SceneBuilder(std::string name) { scene_.name = std::move(name); }

  std::int32_t image(Image image) {
    scene_.images.push_back(std::move(image));
    return static_cast<std::int32_t>(scene_.images.size() - 1);
  }

  std::int32_t material(Material material) {
    scene_.materials.push_back(std::move(material));
    return static_cast<std::int32_t>(scene_.materials.size() - 1);
  }

  /// Keeps a shape for placing; one without triangles is dropped when it is placed.
  std::uint32_t shape(Primitive mesh, std::int32_t material) {
    mesh.material = material;
    scene_.primitives.push_back(std::move(mesh));
    return static_cast<std::uint32_t>(scene_.primitives.size() - 1);
  }

  void add(std::uint32_t shape, const glm::mat4& transform = glm::mat4(1.0F)) {
    if (scene_.primitives[shape].indices.empty()) return;
    scene_.instances.push_back({shape, transform});
  }

  void add(const Model& model, const glm::mat4& transform) {
    for (const std::uint32_t shape : model) add(shape, transform);
  }

  /// A shape that stands only once.
  void addOnce(Primitive mesh, std::int32_t material,
               const glm::mat4& transform = glm::mat4(1.0F)) {
    add(shape(std::move(mesh), material), transform);
  }

  void light(const Light& light) { scene_.lights.push_back(light); }
  void camera(const Camera& camera) { scene_.cameras.push_back(camera); }
  void ambient(const glm::vec3& radiance) { scene_.ambient = radiance; }
  void occlusion(const AmbientOcclusion& occlusion) { scene_.occlusion = occlusion; }

  [[nodiscard]] const Primitive& mesh(std::uint32_t shape) const {
    return scene_.primitives[shape];
  }
  [[nodiscard]] Scene finish() && { return std::move(scene_); }

 private:
  Scene scene_;
};

/// A lit material without textures.
/// @param color linear RGB and alpha; alpha below 1 makes it blend
/// @param roughness perceptual, 0..1
/// @param metallic 0..1
[[nodiscard]] inline Material plainMaterial(std::string name, const glm::vec4& color,
                                            float roughness, float metallic = 0.0F) {
  Material material;
  material.name = std::move(name);
  material.baseColor = color;
  material.roughness = roughness;
  material.metallic = metallic;
  if (color.a < 1.0F) material.alphaMode = AlphaMode::Blend;
  return material;
}

/// Glass: a tinted, double-sided blend.
[[nodiscard]] inline Material glassMaterial(std::string name, const glm::vec4& tint) {
  constexpr float kPolish = 0.08F;  // smooth, with a highlight that is still wider than a pixel
  Material material = plainMaterial(std::move(name), tint, kPolish);
  material.alphaMode = AlphaMode::Blend;
  material.doubleSided = true;
  return material;
}

/// Unlit smoke, coloured and faded by its vertices.
[[nodiscard]] inline Material smokeMaterial() {
  Material material;
  material.name = "smoke";
  material.alphaMode = AlphaMode::Blend;
  material.doubleSided = true;
  material.unlit = true;
  return material;
}

/// A lamp that shines to all sides. @param candela luminous intensity; range in metres
[[nodiscard]] inline Light pointLight(const glm::vec3& position, const glm::vec3& color,
                                      float candela, float range) {
  Light light;
  light.type = LightType::Point;
  light.position = position;
  light.color = color;
  light.intensity = candela;
  light.range = range;
  return light;
}

/// A lamp that shines from `position` towards `target` in a soft cone; angle in radians.
[[nodiscard]] inline Light spotLight(const glm::vec3& position, const glm::vec3& target,
                                     const glm::vec3& color, float candela, float outerAngle) {
  Light light;
  light.type = LightType::Spot;
  light.position = position;
  light.direction = glm::normalize(target - position);
  light.color = color;
  light.intensity = candela;
  light.innerConeAngle = 0.6F * outerAngle;
  light.outerConeAngle = outerAngle;
  return light;
}

/// Sunlight that casts shadows. @param direction the way it travels
[[nodiscard]] inline Light sun(const glm::vec3& direction, const glm::vec3& color, float lux) {
  Light light;
  light.direction = glm::normalize(direction);
  light.color = color;
  light.intensity = lux;
  light.castsShadow = true;
  return light;
}

}  // namespace macula::scene
