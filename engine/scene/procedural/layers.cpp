#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/recipes.h"

namespace macula::scene {
namespace {

constexpr float kNearest = 1.0F;    // metres from the camera to layer 1
constexpr float kFarthest = 10.0F;  // and to layer N
constexpr float kTanHalfFov = 0.5F;
constexpr float kWidestAspect = 4.0F;
constexpr float kMargin = 1.05F;  // beyond the frame's edge, so that no rounding uncovers it

}  // namespace

glm::vec3 layerColor(int i, int /*n*/) {
  const auto residue = [i](int factor, int modulus) {
    return static_cast<float>(i * factor % modulus) / static_cast<float>(modulus - 1);
  };
  return {residue(37, 101), residue(53, 103), residue(71, 107)};
}

float layerAlpha(int i, int n) {
  return 1.0F / static_cast<float>(n - i + 1);
}

glm::vec3 layersComposite(int n) {
  glm::dvec3 sum(0.0);
  for (int i = 1; i <= n; ++i) sum += glm::dvec3(layerColor(i, n));
  return glm::vec3(sum / static_cast<double>(n));
}

Scene makeLayers(int n, std::uint64_t seed) {
  Scene scene;
  scene.name = "layers-" + std::to_string(n);

  Material material;
  material.name = "layers";
  material.unlit = true;
  material.doubleSided = true;
  material.alphaMode = AlphaMode::Blend;
  scene.materials.push_back(material);

  std::vector<int> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 1);
  Random random(seed);
  for (std::size_t i = order.size(); i > 1; --i) {  // Fisher-Yates
    std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
  }

  Primitive quads;
  quads.material = 0;
  for (const int layer : order) {
    const float t = n > 1 ? static_cast<float>(layer - 1) / static_cast<float>(n - 1) : 0.0F;
    const float distance = kNearest + (kFarthest - kNearest) * t;
    const float y = distance * kTanHalfFov * kMargin;
    const float x = y * kWidestAspect;
    const std::size_t first = quads.positions.size();
    addQuad(quads, {-x, -y, -distance}, {x, -y, -distance}, {x, y, -distance}, {-x, y, -distance});
    paint(quads, glm::vec4(layerColor(layer, n), layerAlpha(layer, n)), first);
  }
  scene.primitives.push_back(std::move(quads));
  scene.instances.push_back({0, glm::mat4(1.0F)});

  Camera camera;
  camera.name = "scene";
  camera.verticalFov = 2.0F * std::atan(kTanHalfFov);
  camera.nearPlane = 0.5F * kNearest;
  camera.farPlane = 1.2F * kFarthest;
  scene.cameras.push_back(camera);
  camera.name = "still";
  scene.cameras.push_back(camera);
  return scene;
}

}  // namespace macula::scene
