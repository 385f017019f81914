// Computes the parts of a mesh that a renderer needs and a file may omit: triangle lists, normals,
// tangents.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene {

enum class Topology : std::uint8_t { Triangles, TriangleStrip, TriangleFan };

/// Rewrites strips and fans as three indices a triangle, with the winding of glTF 2.0, section
/// 3.7.2.1. Indices left over at the end are dropped.
[[nodiscard]] std::vector<std::uint32_t> triangleList(Topology topology,
                                                      std::span<const std::uint32_t> indices);

/// Gives each triangle its own three vertices with the triangle's normal, as glTF 2.0 asks where
/// normals are missing. Afterwards positions, attributes and indices are equally many. A triangle
/// without area keeps the default normal.
void splitWithFlatNormals(Primitive& primitive);

/// Makes normals unit length; one that is zero or not finite becomes the sum of the normals of its
/// triangles, weighted by area. @return how many were replaced
std::uint64_t repairNormals(Primitive& primitive);

/// Computes a tangent for each vertex from positions, unit normals and one UV set: the gradient of
/// u summed over the triangles of the vertex, weighted by their area in UV space, made orthogonal
/// to the normal (Lengyel 2001, "Computing Tangent Space Basis Vectors for an Arbitrary Mesh").
/// Deviates from MikkTSpace, which glTF names, in its weights and in not splitting vertices
/// where mirrored UVs meet. w is glTF's: the bitangent w * cross(normal, tangent) points to
/// decreasing v, up in the image. Where the UVs have no gradient, any perpendicular tangent.
/// @param uvSet 0 or 1
void computeTangents(Primitive& primitive, int uvSet);

/// Makes tangents of a file unit length and orthogonal to the normals, and w -1 or 1.
void repairTangents(Primitive& primitive);

}  // namespace macula::scene
