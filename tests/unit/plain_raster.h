// A plain rasteriser in double precision for tests: slow, short, and independent of the engine's.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene::plain {

/// One covered pixel: its place, its distance along the view axis (metres), and the vertex weights.
struct Hit {
  int x = 0;
  int y = 0;  ///< from the top
  double depth = 0.0;
  glm::dvec3 weights{0.0};
};

/// The camera's frame and focal length.
struct PlainView {
  glm::dvec3 position, right, up, forward;
  double tanHalf, nearPlane;
  int width, height;
  /// Only these pixels are drawn: first column and row, and one past the last.
  int x0 = 0, y0 = 0, x1, y1;

  PlainView(const Camera& camera, int w, int h)
      : position(camera.position),
        forward(glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.position))),
        tanHalf(std::tan(0.5 * static_cast<double>(camera.verticalFov))),
        nearPlane(static_cast<double>(camera.nearPlane)),
        width(w),
        height(h),
        x1(w),
        y1(h) {
    right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
    up = glm::cross(right, forward);
  }

  /// x to the right, y up, z = distance along the view axis.
  [[nodiscard]] glm::dvec3 toView(const glm::dvec3& world) const {
    const glm::dvec3 v = world - position;
    return {glm::dot(v, right), glm::dot(v, up), glm::dot(v, forward)};
  }
};

struct ClipVertex {
  glm::dvec3 view;
  glm::dvec3 weights;
};

/// Cuts a triangle at the near plane: none, three or four corners remain.
inline std::vector<ClipVertex> clipNear(const std::array<ClipVertex, 3>& in, double nearPlane) {
  std::vector<ClipVertex> out;
  for (std::size_t i = 0; i < 3; ++i) {
    const ClipVertex& a = in[i];
    const ClipVertex& b = in[(i + 1) % 3];
    const double da = a.view.z - nearPlane;
    const double db = b.view.z - nearPlane;
    if (da >= 0.0) out.push_back(a);
    if ((da >= 0.0) != (db >= 0.0)) {
      const double t = da / (da - db);
      out.push_back({glm::mix(a.view, b.view, t), glm::mix(a.weights, b.weights, t)});
    }
  }
  return out;
}

/// Calls `visit(Hit)` for the pixel centres inside a view-space triangle.
/// @param twoSided else a triangle that is clockwise on the screen is skipped
template <typename Visit>
void drawTriangle(const PlainView& view, const std::array<ClipVertex, 3>& corners, bool twoSided,
                  const Visit& visit) {
  std::array<glm::dvec2, 3> p;
  const double focal = 0.5 * view.height / view.tanHalf;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3& v = corners[i].view;
    p[i] = {0.5 * view.width + v.x / v.z * focal, 0.5 * view.height - v.y / v.z * focal};
  }
  const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
  const double area = cross(p[1] - p[0], p[2] - p[0]);
  // y points down here, so that counter-clockwise in the world is a negative area.
  if (area == 0.0 || (area > 0.0 && !twoSided)) return;
  const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
  const auto pixel = [](double v, int last) {
    return static_cast<int>(std::clamp(std::floor(v), -1.0, static_cast<double>(last)));
  };
  for (int y = std::max(view.y0, pixel(top, view.y1)); y <= pixel(bottom, view.y1 - 1); ++y) {
    for (int x = std::max(view.x0, pixel(left, view.x1)); x <= pixel(right, view.x1 - 1); ++x) {
      const glm::dvec2 c{x + 0.5, y + 0.5};
      const glm::dvec3 w = glm::dvec3(cross(p[2] - p[1], c - p[1]), cross(p[0] - p[2], c - p[2]),
                                      cross(p[1] - p[0], c - p[0])) /
                           area;
      // A centre exactly on an edge belongs to both triangles: rare, and at most one too many.
      if (w.x < 0.0 || w.y < 0.0 || w.z < 0.0) continue;
      const glm::dvec3 overZ =
          w / glm::dvec3(corners[0].view.z, corners[1].view.z, corners[2].view.z);
      Hit hit{x, y, 1.0 / (overZ.x + overZ.y + overZ.z), {}};
      for (std::size_t i = 0; i < 3; ++i) {
        hit.weights += corners[i].weights * (overZ[static_cast<int>(i)] * hit.depth);
      }
      visit(hit);
    }
  }
}

/// Calls `visit(instance, index of the triangle's first index, Hit)` for everything that
/// `choose(material)` picks.
template <typename Choose, typename Visit>
void drawScene(const Scene& scene, const PlainView& view, const Choose& choose,
               const Visit& visit) {
  std::vector<glm::dvec3> points;
  for (const Instance& instance : scene.instances) {
    const Primitive& mesh = scene.primitives[instance.primitive];
    const Material& material = scene.materialOf(mesh);
    if (!choose(material)) continue;
    points.clear();
    for (const glm::vec3& position : mesh.positions) {
      points.push_back(view.toView(glm::dvec3(instance.transform * glm::vec4(position, 1.0F))));
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      std::array<ClipVertex, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        glm::dvec3 weights(0.0);
        weights[static_cast<int>(k)] = 1.0;
        corners[k] = {points[mesh.indices[i + k]], weights};
      }
      const std::vector<ClipVertex> cut = clipNear(corners, view.nearPlane);
      for (std::size_t k = 2; k < cut.size(); ++k) {
        drawTriangle(view, {cut[0], cut[k - 1], cut[k]}, material.doubleSided,
                     [&](const Hit& hit) { visit(instance, i, hit); });
      }
    }
  }
}

/// How many transparent fragments pass opaque depth.
struct DepthCounts {
  int maximum = 0;
  std::uint64_t total = 0;
  std::uint64_t covered = 0;  ///< pixels with at least one
  int deepestX = 0;           ///< the first pixel of `maximum`, rows from the top
  int deepestY = 0;
};

inline DepthCounts countTransparent(const Scene& scene, const PlainView& view) {
  const int size = view.width;
  const auto at = [size](const Hit& hit) { return static_cast<std::size_t>(hit.y * size + hit.x); };
  const auto pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  std::vector<double> opaque(pixels, std::numeric_limits<double>::infinity());
  drawScene(
      scene, view, [](const Material& m) { return !m.isTransparent(); },
      [&](const Instance&, std::size_t, const Hit& hit) {
        opaque[at(hit)] = std::min(opaque[at(hit)], hit.depth);
      });
  std::vector<int> counts(pixels, 0);
  drawScene(
      scene, view, [](const Material& m) { return m.isTransparent(); },
      [&](const Instance&, std::size_t, const Hit& hit) {
        if (hit.depth < opaque[at(hit)]) ++counts[at(hit)];
      });
  DepthCounts result;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const int count = counts[i];
    if (count > result.maximum) {
      result.maximum = count;
      result.deepestX = static_cast<int>(i) % size;
      result.deepestY = static_cast<int>(i) / size;
    }
    result.total += static_cast<std::uint64_t>(count);
    result.covered += count > 0 ? 1U : 0U;
  }
  return result;
}

inline DepthCounts countTransparent(const Scene& scene, const Camera& camera, int size) {
  return countTransparent(scene, PlainView(camera, size, size));
}

}  // namespace macula::scene::plain
