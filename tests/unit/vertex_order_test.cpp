// The order of drawing changes no triangle.
#include "engine/scene/vertex_order.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>

#include "engine/core/random.h"

namespace macula::scene {
namespace {

/// A grid of quads whose triangles come in random order, with a vertex in front that none uses.
Primitive shuffledGrid(std::uint32_t side) {
  Primitive grid;
  grid.material = 3;
  grid.positions.emplace_back(-9.0F);
  for (std::uint32_t i = 0; i < side * side; ++i) {
    grid.positions.emplace_back(i % side, i / side, 0.25F);
  }
  grid.attributes.resize(grid.positions.size());
  for (std::size_t i = 0; i < grid.positions.size(); ++i) {
    grid.attributes[i].uv0 = glm::vec2(grid.positions[i]);
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t i = 0; i < side * (side - 1); ++i) {
    if (i % side == side - 1) continue;
    triangles.push_back({i + 1, i + 2, i + 1 + side});
    triangles.push_back({i + 2, i + 2 + side, i + 1 + side});
  }
  Random random(7, 1);
  for (std::uint32_t i = static_cast<std::uint32_t>(triangles.size()); i > 1; --i) {
    std::swap(triangles[i - 1], triangles[random.below(i)]);
  }
  for (const auto& triangle : triangles) {
    grid.indices.insert(grid.indices.end(), triangle.begin(), triangle.end());
  }
  return grid;
}

/// Each triangle as its corners' places, from the lowest on, so that its winding shows; sorted.
std::vector<std::array<float, 6>> trianglesOf(const Primitive& p) {
  std::vector<std::array<float, 6>> all;
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    std::array<glm::vec2, 3> c{};
    for (std::size_t k = 0; k < 3; ++k) c[k] = glm::vec2(p.positions[p.indices[i + k]]);
    const auto lower = [](glm::vec2 a, glm::vec2 b) {
      return a.y < b.y || (a.y == b.y && a.x < b.x);
    };
    std::rotate(c.begin(), std::min_element(c.begin(), c.end(), lower), c.end());
    all.push_back({c[0].x, c[0].y, c[1].x, c[1].y, c[2].x, c[2].y});
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Vertices that a cache of the last 16 does not hold.
std::size_t missesOf(const Primitive& p) {
  std::vector<std::uint32_t> cache;
  std::size_t misses = 0;
  for (const std::uint32_t index : p.indices) {
    if (std::find(cache.begin(), cache.end(), index) != cache.end()) continue;
    ++misses;
    cache.push_back(index);
    if (cache.size() > 16) cache.erase(cache.begin());
  }
  return misses;
}

TEST(VertexOrder, KeepsEveryTriangleWithItsWindingAndAttributes) {
  const Primitive grid = shuffledGrid(20);
  const Primitive ordered = orderedForDrawing(grid);
  EXPECT_EQ(trianglesOf(ordered), trianglesOf(grid));
  EXPECT_EQ(ordered.material, 3);
  ASSERT_EQ(ordered.positions.size(), 400U) << "without the vertex that no triangle uses";
  ASSERT_EQ(ordered.attributes.size(), 400U);
  for (std::size_t i = 0; i < ordered.positions.size(); ++i) {
    EXPECT_EQ(ordered.attributes[i].uv0, glm::vec2(ordered.positions[i]));
  }
}

TEST(VertexOrder, LetsNeighboursFollowEachOther) {
  const Primitive grid = shuffledGrid(20);
  EXPECT_LT(2 * missesOf(orderedForDrawing(grid)), missesOf(grid));
}

TEST(VertexOrder, TakesAPrimitiveOfNothing) {
  Primitive nothing;
  nothing.material = 1;
  EXPECT_TRUE(orderedForDrawing(nothing).indices.empty());
  EXPECT_EQ(orderedForDrawing(nothing).material, 1);
}

}  // namespace
}  // namespace macula::scene
