#include "engine/scene/procedural/patch.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "engine/scene/procedural/mesh_builder.h"

namespace macula::scene {
namespace {

// Of a triangle's doubled area in square metres: thinner ones have no direction of their own.
constexpr float kLeastArea = 1e-9F;

// Between a triangle and the normals of its corners: beyond 87 degrees it is a crease and is flat.
constexpr float kLeastCosine = 0.05F;

/// The two triangles of a cell as indices into the patch.
std::array<std::array<std::size_t, 3>, 2> trianglesOf(const Patch& patch, int row, int column) {
  const std::size_t a = patch.index(row, column);
  const std::size_t b = patch.index(row, column + 1);
  const std::size_t c = patch.index(row + 1, column + 1);
  const std::size_t d = patch.index(row + 1, column);
  return {{{a, b, c}, {a, c, d}}};
}

bool coincides(const Patch& patch, int row) {
  for (int j = 1; j < patch.columns(); ++j) {
    if (patch.at(row, j).position != patch.at(row, 0).position) return false;
  }
  return true;
}

bool isRing(const Patch& patch) {
  for (int i = 0; i < patch.rows(); ++i) {
    if (glm::distance(patch.at(i, 0).position, patch.at(i, patch.columns() - 1).position) > 1e-6F) {
      return false;
    }
  }
  return true;
}

const PatchPoint& pointOf(const Patch& patch, std::size_t index) {
  const auto columns = static_cast<std::size_t>(patch.columns());
  return patch.at(static_cast<int>(index / columns), static_cast<int>(index % columns));
}

/// Twice the area times the direction that the triangle faces.
glm::vec3 facing(const Patch& patch, const std::array<std::size_t, 3>& triangle) {
  const glm::vec3& a = pointOf(patch, triangle[0]).position;
  return glm::cross(pointOf(patch, triangle[1]).position - a,
                    pointOf(patch, triangle[2]).position - a);
}

std::vector<glm::vec3> normalsOf(const Patch& patch) {
  const int last = patch.columns() - 1;
  std::vector<glm::vec3> sums(
      static_cast<std::size_t>(patch.rows()) * static_cast<std::size_t>(patch.columns()),
      glm::vec3(0.0F));
  for (int i = 0; i + 1 < patch.rows(); ++i) {
    for (int j = 0; j < last; ++j) {
      for (const auto& triangle : trianglesOf(patch, i, j)) {
        const glm::vec3 normal = facing(patch, triangle);
        for (const std::size_t corner : triangle) sums[corner] += normal;
      }
    }
  }
  if (isRing(patch)) {
    for (int i = 0; i < patch.rows(); ++i) {
      sums[patch.index(i, 0)] += sums[patch.index(i, last)];
      sums[patch.index(i, last)] = sums[patch.index(i, 0)];
    }
  }
  for (const int row : {0, patch.rows() - 1}) {
    if (!coincides(patch, row)) continue;
    glm::vec3 sum(0.0F);
    for (int j = 0; j <= last; ++j) sum += sums[patch.index(row, j)];
    for (int j = 0; j <= last; ++j) sums[patch.index(row, j)] = sum;
  }
  for (glm::vec3& sum : sums) {
    const float length = glm::length(sum);
    sum = length > 0.0F ? sum / length : glm::vec3(0.0F, 1.0F, 0.0F);
  }
  return sums;
}

}  // namespace

void addPatch(Primitive& mesh, const Patch& patch, const ChooseCell& choose) {
  const std::vector<glm::vec3> normals = normalsOf(patch);
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> vertexOf(normals.size(), kUnused);
  for (int i = 0; i + 1 < patch.rows(); ++i) {
    for (int j = 0; j + 1 < patch.columns(); ++j) {
      if (choose && !choose(i, j)) continue;
      for (const auto& triangle : trianglesOf(patch, i, j)) {
        const glm::vec3 face = facing(patch, triangle);
        if (glm::length(face) < kLeastArea) continue;
        const bool creased = std::any_of(triangle.begin(), triangle.end(), [&](std::size_t k) {
          return glm::dot(face, normals[k]) < kLeastCosine * glm::length(face);
        });
        for (const std::size_t corner : triangle) {
          const PatchPoint& point = pointOf(patch, corner);
          if (creased) {
            mesh.indices.push_back(
                addVertex(mesh, point.position, glm::normalize(face), point.uv, point.color));
            continue;
          }
          if (vertexOf[corner] == kUnused) {
            vertexOf[corner] =
                addVertex(mesh, point.position, normals[corner], point.uv, point.color);
          }
          mesh.indices.push_back(vertexOf[corner]);
        }
      }
    }
  }
}

float curveAt(std::span<const glm::vec2> keys, float x) {
  if (x <= keys.front().x) return keys.front().y;
  if (x >= keys.back().x) return keys.back().y;
  std::size_t i = 0;
  while (keys[i + 1].x < x) ++i;
  const auto slope = [&](std::size_t k) {
    return (keys[k + 1].y - keys[k].y) / (keys[k + 1].x - keys[k].x);
  };
  const auto tangent = [&](std::size_t k) {
    if (k == 0) return slope(0);
    if (k + 1 == keys.size()) return slope(k - 1);
    const float before = slope(k - 1);
    const float after = slope(k);
    return before * after > 0.0F ? 2.0F * before * after / (before + after) : 0.0F;
  };
  const float span = keys[i + 1].x - keys[i].x;
  const float t = (x - keys[i].x) / span;
  const float t2 = t * t;
  const float t3 = t2 * t;
  return (2.0F * t3 - 3.0F * t2 + 1.0F) * keys[i].y + (t3 - 2.0F * t2 + t) * span * tangent(i) +
         (3.0F * t2 - 2.0F * t3) * keys[i + 1].y + (t3 - t2) * span * tangent(i + 1);
}

glm::vec3 splineBetween(const glm::vec3& p0, const glm::vec3& p1, const glm::vec3& p2,
                        const glm::vec3& p3, float t) {
  const glm::vec3 a = 2.0F * p1;
  const glm::vec3 b = p2 - p0;
  const glm::vec3 c = 2.0F * p0 - 5.0F * p1 + 4.0F * p2 - p3;
  const glm::vec3 d = 3.0F * p1 - p0 - 3.0F * p2 + p3;
  return 0.5F * (a + (b + (c + d * t) * t) * t);
}

}  // namespace macula::scene
