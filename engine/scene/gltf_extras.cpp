#include "engine/scene/gltf_extras.h"

#include <algorithm>
#include <cmath>

namespace macula::scene::gltf {
namespace {

// Brighter or farther than anything that can be drawn; keeps malformed numbers finite.
constexpr double kMost = 1e6;

double numberIn(const tinygltf::Value& value) {
  const double number = value.IsNumber() ? value.GetNumberAsDouble() : 0.0;
  return std::isfinite(number) ? std::clamp(number, 0.0, kMost) : 0.0;
}

/// A member of an object; a value of no kind where there is none.
const tinygltf::Value& memberOf(const tinygltf::Value& value, const char* name) {
  static const tinygltf::Value kNothing;
  return value.Has(name) ? value.Get(std::string(name)) : kNothing;
}

/// The scene that is drawn; nullptr where the file has none.
const tinygltf::Scene* drawnScene(const Document& document) {
  const auto& scenes = document.model.scenes;
  const auto chosen = static_cast<std::size_t>(std::max(document.model.defaultScene, 0));
  return chosen < scenes.size() ? &scenes[chosen] : nullptr;
}

/// Linear RGB; black where it is no array of three.
glm::vec3 colorIn(const tinygltf::Value& value) {
  glm::vec3 color(0.0F);
  for (int c = 0; c < 3 && value.IsArray() && value.ArrayLen() == 3; ++c) {
    color[c] = static_cast<float>(numberIn(value.Get(c)));
  }
  return color;
}

}  // namespace

bool castsShadow(const tinygltf::Light& light) {
  const tinygltf::Value& value = memberOf(light.extras, "macula_casts_shadow");
  return value.IsBool() && value.Get<bool>();
}

int shadowTaps(const tinygltf::Light& light) {
  const tinygltf::Value& value = memberOf(light.extras, "macula_shadow_taps");
  if (!value.IsNumber()) return kUsualShadowTaps;
  const double taps = std::clamp(numberIn(value), 1.0, static_cast<double>(kMostShadowTaps));
  return static_cast<int>(taps) | 1;  // an even number has no middle tap: one more
}

float targetDistance(const tinygltf::Node& node) {
  return static_cast<float>(numberIn(memberOf(node.extras, "macula_target_distance")));
}

glm::vec3 ambientOf(const Document& document) {
  const tinygltf::Scene* drawn = drawnScene(document);
  return drawn == nullptr ? glm::vec3(0.0F) : colorIn(memberOf(drawn->extras, "macula_ambient"));
}

AmbientOcclusion occlusionOf(const Document& document) {
  const tinygltf::Scene* drawn = drawnScene(document);
  if (drawn == nullptr) return {};
  const tinygltf::Value& value = memberOf(drawn->extras, "macula_occlusion");
  AmbientOcclusion occlusion;
  occlusion.radius = static_cast<float>(numberIn(memberOf(value, "radius")));
  occlusion.samples = static_cast<int>(
      std::min(numberIn(memberOf(value, "samples")), static_cast<double>(kMostOcclusionSamples)));
  return occlusion.any() ? occlusion : AmbientOcclusion{};
}

Veins veinsOf(const tinygltf::Material& material) {
  const tinygltf::Value& value = memberOf(material.extras, "macula_veins");
  Veins veins;
  veins.color = glm::min(colorIn(memberOf(value, "color")), glm::vec3(1.0F));
  veins.scale = static_cast<float>(numberIn(memberOf(value, "scale")));
  return veins.any() ? veins : Veins{};
}

}  // namespace macula::scene::gltf
