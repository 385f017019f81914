#include "engine/scene/procedural/ribbon.h"

#include <algorithm>

#include "engine/scene/procedural/mesh_builder.h"

namespace macula::scene {
namespace {

// How far the normals of both rims lean outwards, as the tangent of the angle: 27 degrees. A whole
// half-circle would turn the rims of a strand edge-on to the light.
constexpr float kRoundness = 0.5F;

}  // namespace

void addRibbon(Primitive& mesh, std::span<const RibbonPoint> points, const glm::vec4& color) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto count = static_cast<std::uint32_t>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec3& before = points[i > 0 ? i - 1 : 0].center;
    const glm::vec3& after = points[std::min(i + 1, points.size() - 1)].center;
    const glm::vec3 along = glm::normalize(after - before);
    const RibbonPoint& point = points[i];
    const glm::vec3 side = glm::normalize(point.side - along * glm::dot(point.side, along));
    const glm::vec3 normal = glm::cross(side, along);
    const float v = static_cast<float>(i) / static_cast<float>(count - 1);
    for (const float sign : {-1.0F, 1.0F}) {
      addVertex(mesh, point.center + side * (sign * point.halfWidth),
                glm::normalize(normal + side * (sign * kRoundness)), {0.5F + 0.5F * sign, v},
                color);
    }
  }
  for (std::uint32_t i = 0; i + 1 < count; ++i) {
    const std::uint32_t a = first + 2 * i;
    mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + 3, a, a + 3, a + 2});
  }
}

bool carrySides(std::span<RibbonPoint> points) {
  constexpr float kLeastCosine = 0.5F;  // between successive pieces: 60 degrees
  glm::vec3 before(0.0F);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const glm::vec3 piece = glm::normalize(points[i].center - points[i - 1].center);
    if (i > 1 && glm::dot(before, piece) < kLeastCosine) return false;
    const glm::vec3& side = points[i - 1].side;
    points[i].side = glm::normalize(side - piece * glm::dot(side, piece));
    before = piece;
  }
  return true;
}

}  // namespace macula::scene
