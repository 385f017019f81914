#include "engine/scene/vertex_order.h"

#include <meshoptimizer.h>

#include <vector>

namespace macula::scene {
namespace {

/// How much longer the list of transformed vertices may become where that hides more.
constexpr float kOverdrawThreshold = 1.05F;  // meshoptimizer's own example

template <typename T>
std::vector<T> moved(const std::vector<T>& values, const std::vector<unsigned>& places,
                     std::size_t count) {
  std::vector<T> result(count);
  meshopt_remapVertexBuffer(result.data(), values.data(), values.size(), sizeof(T), places.data());
  return result;
}

}  // namespace

Primitive orderedForDrawing(const Primitive& primitive) {
  const std::size_t vertices = primitive.positions.size();
  const std::size_t corners = primitive.indices.size();
  Primitive result;
  result.material = primitive.material;
  if (corners == 0) return result;
  std::vector<unsigned> near(corners);
  meshopt_optimizeVertexCache(near.data(), primitive.indices.data(), corners, vertices);
  std::vector<unsigned> hiding(corners);
  meshopt_optimizeOverdraw(hiding.data(), near.data(), corners, &primitive.positions.front().x,
                           vertices, sizeof(glm::vec3), kOverdrawThreshold);
  std::vector<unsigned> places(vertices);
  const std::size_t used =
      meshopt_optimizeVertexFetchRemap(places.data(), hiding.data(), corners, vertices);
  result.indices.resize(corners);
  meshopt_remapIndexBuffer(result.indices.data(), hiding.data(), corners, places.data());
  result.positions = moved(primitive.positions, places, used);
  result.attributes = moved(primitive.attributes, places, used);
  return result;
}

}  // namespace macula::scene
