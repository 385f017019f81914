// Shapes for the recipes. Every function appends to a primitive.
// Triangles run counter-clockwise seen from the side that the normals point to; lengths are metres.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "engine/scene/scene.h"

namespace macula::scene {

/// Appends one vertex and returns its index.
std::uint32_t addVertex(Primitive& mesh, const glm::vec3& position, const glm::vec3& normal,
                        const glm::vec2& uv = glm::vec2(0.0F),
                        const glm::vec4& color = glm::vec4(1.0F));

/// Appends a triangle of vertices that are there.
void addTriangle(Primitive& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c);

/// A flat quad: lower left a, lower right b, upper right c, upper left d, seen from its front. The
/// image's top left (uvMin) comes to d and its bottom right (uvMax) to b.
void addQuad(Primitive& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
             const glm::vec3& d, const glm::vec2& uvMin = glm::vec2(0.0F),
             const glm::vec2& uvMax = glm::vec2(1.0F));

/// A box from `low` to `high` with normals outwards; uv in metres times `uvPerMetre`.
void addBox(Primitive& mesh, const glm::vec3& low, const glm::vec3& high, float uvPerMetre = 1.0F);

/// A box whose upright and level edges are cut at 45 degrees, so that they catch the light.
/// @param bevel width of the cut in metres, below half of the shortest edge
void addBevelledBox(Primitive& mesh, const glm::vec3& low, const glm::vec3& high, float bevel,
                    float uvPerMetre = 1.0F);

/// A surface of revolution about the y axis.
/// @param profile points (radius >= 0, y), at least two. The surface faces to the right of the way
///   along it: walked upwards it faces outwards. Edges of the profile sharper than 45 degrees stay
///   sharp, others are smoothed.
/// @param segments around the axis, >= 3
void addLathe(Primitive& mesh, std::span<const glm::vec2> profile, int segments);

/// A hollow vessel about the y axis: outer and inner wall as one closed surface. The inner wall
/// follows the outer one at the distance `wall` and ends in a bottom of thickness `bottom`.
/// @param outer from the middle of the foot to the lip, (radius, y); radii above `wall`
void addVessel(Primitive& mesh, std::span<const glm::vec2> outer, float wall, float bottom,
               int segments);

/// A sphere with `segments` around and half as many from pole to pole.
void addSphere(Primitive& mesh, const glm::vec3& center, float radius, int segments);

/// A closed or open round tube along `path` with the radius of each point.
/// @param path at least two points, no two in a row equal
/// @param radii as many as points
/// @param closed joins the end to the start
void addTube(Primitive& mesh, std::span<const glm::vec3> path, std::span<const float> radii,
             int segments, bool closed);

/// A (p, q) torus knot about the y axis: the path winds p times around the axis and q times
/// through the hole.
void addTorusKnot(Primitive& mesh, int p, int q, float radius, float tubeRadius, int steps,
                  int segments);

/// A fluted column shaft about the y axis from y = 0 to `height`, narrowing to 85 % at the top.
void addFlutedShaft(Primitive& mesh, float radius, float height, int flutes, int rings);

/// A soft puff of smoke: a round dish, bent so that it is never seen edge-on as a line, whose
/// vertex alpha falls from `alpha` in the middle to 0 at the rim. For double-sided materials.
/// @param axis the way the dish faces, unit length
void addPuff(Primitive& mesh, const glm::vec3& center, const glm::vec3& axis, float radius,
             const glm::vec3& color, float alpha);

/// Appends a copy of `part` moved by `transform` (no mirroring).
void append(Primitive& mesh, const Primitive& part, const glm::mat4& transform);

/// Colours all vertices from index `first` on.
void paint(Primitive& mesh, const glm::vec4& color, std::size_t first = 0);

/// The translation, rotation about y (in turns, counter-clockwise seen from above) and scale that
/// place furniture.
[[nodiscard]] glm::mat4 place(const glm::vec3& position, float turns = 0.0F, float scale = 1.0F);

}  // namespace macula::scene
