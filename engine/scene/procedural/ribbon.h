// Ribbons: the strands of hair and wool.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "engine/scene/scene.h"

namespace macula::scene {

/// One place along a ribbon.
struct RibbonPoint {
  glm::vec3 center{0.0F};            ///< metres
  glm::vec3 side{1.0F, 0.0F, 0.0F};  ///< across the ribbon; need not be at right angles to the path
  float halfWidth = 0.001F;          ///< metres, > 0
};

/// A flat strip along a path, one quad from point to point, with the normals of a half-round strand
/// so that it catches light like one. The front is on the side of cross(side, direction of the
/// path). For double-sided materials.
/// @param points at least two, no two in a row equal; the path turns by less than 60 degrees at
///   each, and no side is parallel to it
/// @param color linear RGB and alpha of every vertex
void addRibbon(Primitive& mesh, std::span<const RibbonPoint> points, const glm::vec4& color);

/// Carries the side of the first point along the path, turning it no more than the path turns.
/// @return whether the path turns nowhere by more than a ribbon can follow
[[nodiscard]] bool carrySides(std::span<RibbonPoint> points);

}  // namespace macula::scene
