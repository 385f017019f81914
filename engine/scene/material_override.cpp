#include "engine/scene/material_override.h"

#include <algorithm>
#include <glm/glm.hpp>
#include <map>
#include <utility>
#include <vector>

namespace macula::scene {
namespace {

// Roughness of an unlit material that must be lit: matt, because its colours are painted.
constexpr float kPaintRoughness = 0.9F;

// Together they light a white diffuse surface to between 0.3 and 1.2 in any orientation. Lamps
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

constexpr std::uint8_t kSolid = 255;
constexpr std::size_t kAlpha = 3;  // byte of a pixel
constexpr std::size_t kPixelBytes = 4;

bool isSolid(const Image& image) {
  for (std::size_t i = kAlpha; i < image.rgba.size(); i += kPixelBytes) {
    if (image.rgba[i] != kSolid) return false;
  }
  return true;
}

/// Images as an OPAQUE material sees them: without alpha. Others may use the same image with it.
class SolidImages {
 public:
  explicit SolidImages(Scene& scene) : scene_(scene) {}

  /// The image itself where it has no alpha, else a copy without; kNone stays.
  std::int32_t of(std::int32_t image) {
    if (image == kNone) return kNone;
    const auto [found, isNew] = copies_.try_emplace(image, image);
    if (isNew && !isSolid(scene_.images[static_cast<std::size_t>(image)])) {
      Image copy = scene_.images[static_cast<std::size_t>(image)];
      for (std::size_t i = kAlpha; i < copy.rgba.size(); i += kPixelBytes) copy.rgba[i] = kSolid;
      found->second = static_cast<std::int32_t>(scene_.images.size());
      scene_.images.push_back(std::move(copy));
    }
    return found->second;
  }

 private:
  Scene& scene_;
  std::map<std::int32_t, std::int32_t> copies_;
};

/// Gives surfaces without a material glTF's default one, so that it can be changed.
void nameDefaultMaterial(Scene& scene) {
  const auto unnamed = [](const Primitive& primitive) { return primitive.material == kNone; };
  if (std::none_of(scene.primitives.begin(), scene.primitives.end(), unnamed)) return;
  const auto added = static_cast<std::int32_t>(scene.materials.size());
  scene.materials.emplace_back();
  for (Primitive& primitive : scene.primitives) {
    if (unnamed(primitive)) primitive.material = added;
  }
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

void overrideOpacity(Scene& scene, float opacity) {
  if (opacity >= 1.0F) return;
  nameDefaultMaterial(scene);
  for (Primitive& primitive : scene.primitives) {
    if (scene.materialOf(primitive).alphaMode != AlphaMode::Opaque) continue;
    for (VertexAttributes& vertex : primitive.attributes) vertex.color.a = 1.0F;
  }
  SolidImages solid(scene);
  for (Material& material : scene.materials) {
    if (material.alphaMode == AlphaMode::Opaque) {
      material.baseColor.a = 1.0F;
      material.baseColorTexture.image = solid.of(material.baseColorTexture.image);
    }
    material.alphaMode = AlphaMode::Blend;
    material.baseColor.a *= opacity;
  }
}

}  // namespace macula::scene
