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

}  // namespace

bool castsShadow(const tinygltf::Light& light) {
  if (!light.extras.Has("macula_casts_shadow")) return false;
  const tinygltf::Value& value = light.extras.Get(std::string("macula_casts_shadow"));
  return value.IsBool() && value.Get<bool>();
}

float targetDistance(const tinygltf::Node& node) {
  if (!node.extras.Has("macula_target_distance")) return 0.0F;
  return static_cast<float>(numberIn(node.extras.Get(std::string("macula_target_distance"))));
}

glm::vec3 ambientOf(const Document& document) {
  const auto& scenes = document.model.scenes;
  const auto chosen = static_cast<std::size_t>(std::max(document.model.defaultScene, 0));
  if (chosen >= scenes.size() || !scenes[chosen].extras.Has("macula_ambient")) {
    return glm::vec3(0.0F);
  }
  const tinygltf::Value& color = scenes[chosen].extras.Get(std::string("macula_ambient"));
  glm::vec3 ambient(0.0F);
  for (int c = 0; c < 3 && color.IsArray() && color.ArrayLen() == 3; ++c) {
    ambient[c] = static_cast<float>(numberIn(color.Get(c)));
  }
  return ambient;
}

}  // namespace macula::scene::gltf
