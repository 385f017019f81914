#include "engine/scene/mesh_attributes.h"

#include <cmath>
#include <utility>

namespace macula::scene {
namespace {

const glm::vec3 kUp{0.0F, 0.0F, 1.0F};  // the default normal of VertexAttributes

// Unit vector, or `otherwise` where v has no direction. In double, because the squares of small
// and large float lengths do not fit into float.
glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& otherwise) {
  const glm::dvec3 exact(v);
  const double length = std::sqrt(glm::dot(exact, exact));
  if (!(length > 0.0) || !std::isfinite(length)) return otherwise;
  return {exact / length};
}

// Twice the area times the normal of a triangle.
glm::vec3 areaNormal(const Primitive& primitive, std::size_t triangle) {
  const std::uint32_t* corner = &primitive.indices[3 * triangle];
  const glm::dvec3 a(primitive.positions[corner[0]]);
  const glm::dvec3 b(primitive.positions[corner[1]]);
  const glm::dvec3 c(primitive.positions[corner[2]]);
  return {glm::cross(b - a, c - a)};
}

// Any unit vector perpendicular to a unit vector: Duff et al. 2017, "Building an Orthonormal Basis,
// Revisited", listing 3.
glm::vec3 perpendicular(const glm::vec3& n) {
  const float sign = std::copysign(1.0F, n.z);
  const float a = -1.0F / (sign + n.z);
  return {1.0F + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

// Gram-Schmidt.
glm::vec3 orthogonal(const glm::vec3& tangent, const glm::vec3& normal) {
  const glm::vec3 unit = unitOr(tangent, perpendicular(normal));
  const glm::vec3 rest = unit - normal * glm::dot(normal, unit);
  // Parallel to the normal but for rounding: no direction is left in the remainder.
  constexpr float kParallel = 1e-6F;
  if (!(glm::dot(rest, rest) > kParallel * kParallel)) return perpendicular(normal);
  return glm::normalize(rest);
}

}  // namespace

std::vector<std::uint32_t> triangleList(Topology topology, std::span<const std::uint32_t> indices) {
  std::vector<std::uint32_t> list;
  if (topology == Topology::Triangles) {
    list.assign(indices.begin(),
                indices.begin() + static_cast<std::ptrdiff_t>(indices.size() / 3 * 3));
    return list;
  }
  if (indices.size() < 3) return list;
  const std::size_t triangles = indices.size() - 2;
  list.reserve(3 * triangles);
  for (std::size_t i = 0; i < triangles; ++i) {
    if (topology == Topology::TriangleStrip) {
      const std::size_t odd = i % 2;
      list.insert(list.end(), {indices[i], indices[i + 1 + odd], indices[i + 2 - odd]});
    } else {
      list.insert(list.end(), {indices[i + 1], indices[i + 2], indices[0]});
    }
  }
  return list;
}

void splitWithFlatNormals(Primitive& primitive) {
  Primitive split;
  split.material = primitive.material;
  split.positions.reserve(primitive.indices.size());
  split.attributes.reserve(primitive.indices.size());
  split.indices.reserve(primitive.indices.size());
  for (std::size_t i = 0; i < primitive.indices.size(); ++i) {
    const std::uint32_t vertex = primitive.indices[i];
    split.positions.push_back(primitive.positions[vertex]);
    split.attributes.push_back(primitive.attributes[vertex]);
    split.attributes.back().normal = unitOr(areaNormal(primitive, i / 3), kUp);
    split.indices.push_back(static_cast<std::uint32_t>(i));
  }
  primitive = std::move(split);
}

std::uint64_t repairNormals(Primitive& primitive) {
  std::uint64_t broken = 0;
  const glm::vec3 none(0.0F);
  for (VertexAttributes& vertex : primitive.attributes) {
    vertex.normal = unitOr(vertex.normal, none);
    if (vertex.normal == none) ++broken;
  }
  if (broken == 0) return 0;
  std::vector<glm::vec3> sums(primitive.attributes.size(), none);
  for (std::size_t i = 0; i < primitive.indices.size(); ++i) {
    const std::uint32_t vertex = primitive.indices[i];
    if (primitive.attributes[vertex].normal == none) sums[vertex] += areaNormal(primitive, i / 3);
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    glm::vec3& normal = primitive.attributes[i].normal;
    if (normal == none) normal = unitOr(sums[i], kUp);
  }
  return broken;
}

void computeTangents(Primitive& primitive, int uvSet) {
  const auto uvOf = [&](std::uint32_t vertex) {
    const VertexAttributes& a = primitive.attributes[vertex];
    return uvSet == 0 ? a.uv0 : a.uv1;
  };
  std::vector<glm::vec3> alongU(primitive.positions.size(), glm::vec3(0.0F));
  std::vector<glm::vec3> alongV(primitive.positions.size(), glm::vec3(0.0F));
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const std::uint32_t* corner = &primitive.indices[i];
    const glm::vec3 edge1 = primitive.positions[corner[1]] - primitive.positions[corner[0]];
    const glm::vec3 edge2 = primitive.positions[corner[2]] - primitive.positions[corner[0]];
    const glm::vec2 uv1 = uvOf(corner[1]) - uvOf(corner[0]);
    const glm::vec2 uv2 = uvOf(corner[2]) - uvOf(corner[0]);
    // The gradients times |area|, so that triangles without UV area add nothing.
    const float area = uv1.x * uv2.y - uv2.x * uv1.y;
    const float sign = area < 0.0F ? -1.0F : 1.0F;
    const glm::vec3 u = (edge1 * uv2.y - edge2 * uv1.y) * sign;
    const glm::vec3 v = (edge2 * uv1.x - edge1 * uv2.x) * sign;
    if (area == 0.0F || !std::isfinite(glm::dot(u, u) + glm::dot(v, v))) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      alongU[corner[c]] += u;
      alongV[corner[c]] += v;
    }
  }
  for (std::size_t i = 0; i < primitive.attributes.size(); ++i) {
    VertexAttributes& vertex = primitive.attributes[i];
    const glm::vec3 tangent = orthogonal(alongU[i], vertex.normal);
    // v runs down the image, the bitangent up.
    const float down = glm::dot(glm::cross(vertex.normal, tangent), alongV[i]);
    vertex.tangent = glm::vec4(tangent, down > 0.0F ? -1.0F : 1.0F);
  }
}

void repairTangents(Primitive& primitive) {
  for (VertexAttributes& vertex : primitive.attributes) {
    const float w = vertex.tangent.w < 0.0F ? -1.0F : 1.0F;
    vertex.tangent = glm::vec4(orthogonal(glm::vec3(vertex.tangent), vertex.normal), w);
  }
}

}  // namespace macula::scene
