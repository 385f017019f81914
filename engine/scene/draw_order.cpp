#include "engine/scene/draw_order.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/scene/camera_path.h"

namespace macula::scene {
namespace {

constexpr std::uint64_t kRandomStream = 71;  // apart from those of the recipes

glm::vec3 eyeOf(const Scene& scene) {
  return scene.cameras.empty() ? autoOrbit(scene).at(0.0).position : scene.cameras.front().position;
}

float squaredDistance(const glm::vec3& a, const glm::vec3& b) {
  return glm::dot(a - b, a - b);
}

/// 0, 1, ... in the order in which things at these distances are to be drawn.
std::vector<std::size_t> ranked(const std::vector<float>& distances, TransparentOrder order,
                                Random& random) {
  std::vector<std::size_t> ranks(distances.size());
  std::iota(ranks.begin(), ranks.end(), std::size_t{0});
  if (order == TransparentOrder::Random) {
    // Fisher and Yates; std::shuffle differs between libraries.
    for (std::size_t i = ranks.size(); i > 1; --i) {
      std::swap(ranks[i - 1], ranks[random.below(static_cast<std::uint32_t>(i))]);
    }
    return ranks;
  }
  std::stable_sort(ranks.begin(), ranks.end(), [&](std::size_t a, std::size_t b) {
    return order == TransparentOrder::NearFirst ? distances[a] < distances[b]
                                                : distances[a] > distances[b];
  });
  return ranks;
}

void orderTriangles(Primitive& mesh, const glm::mat4& transform, const glm::vec3& eye,
                    TransparentOrder order, Random& random) {
  std::vector<float> distances;
  distances.reserve(mesh.indices.size() / 3);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::vec3 sum = mesh.positions[mesh.indices[i]] + mesh.positions[mesh.indices[i + 1]] +
                          mesh.positions[mesh.indices[i + 2]];
    distances.push_back(squaredDistance(glm::vec3(transform * glm::vec4(sum / 3.0F, 1.0F)), eye));
  }
  std::vector<std::uint32_t> indices;
  indices.reserve(mesh.indices.size());
  for (const std::size_t triangle : ranked(distances, order, random)) {
    for (std::size_t k = 0; k < 3; ++k) indices.push_back(mesh.indices[3 * triangle + k]);
  }
  mesh.indices = std::move(indices);
}

glm::vec3 middleOf(const Primitive& mesh) {
  Bounds box;
  for (const glm::vec3& p : mesh.positions) box.add(p);
  return box.center();
}

}  // namespace

void orderTransparent(Scene& scene, TransparentOrder order, std::uint64_t seed) {
  if (order == TransparentOrder::File) return;
  const glm::vec3 eye = eyeOf(scene);
  Random random(seed, kRandomStream);

  std::vector<glm::vec3> middles(scene.primitives.size());
  for (std::size_t i = 0; i < middles.size(); ++i) middles[i] = middleOf(scene.primitives[i]);
  std::vector<std::size_t> places;  // of the transparent instances
  std::vector<float> distances;
  std::vector<float> nearest(scene.primitives.size(), std::numeric_limits<float>::infinity());
  std::vector<glm::mat4> nearestTransform(scene.primitives.size(), glm::mat4(1.0F));
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    if (!scene.materialOf(scene.primitives[instance.primitive]).isTransparent()) continue;
    const glm::vec3 middle(instance.transform * glm::vec4(middles[instance.primitive], 1.0F));
    places.push_back(i);
    distances.push_back(squaredDistance(middle, eye));
    if (distances.back() < nearest[instance.primitive]) {
      nearest[instance.primitive] = distances.back();
      nearestTransform[instance.primitive] = instance.transform;
    }
  }

  const std::vector<Instance> before = scene.instances;
  const std::vector<std::size_t> ranks = ranked(distances, order, random);
  for (std::size_t i = 0; i < places.size(); ++i) {
    scene.instances[places[i]] = before[places[ranks[i]]];
  }
  for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
    Primitive& mesh = scene.primitives[i];
    if (!scene.materialOf(mesh).isTransparent()) continue;
    orderTriangles(mesh, nearestTransform[i], eye, order, random);
  }
}

}  // namespace macula::scene
