#include "engine/scene/procedural/depth_counter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace macula::scene {
namespace {

constexpr std::int64_t kSubPixels = 256;
// Corners farther out than this many frame widths are moved there, so that products of two
// coordinates stay within 64 bits.
constexpr float kFarthestCorner = 64.0F;

/// An edge function of a triangle (Pineda 1988): at least zero on the inner side.
struct Edge {
  std::int64_t row = 0;  ///< at the first pixel of the present row
  std::int64_t stepX = 0;
  std::int64_t stepY = 0;
};

std::int64_t floorDivide(std::int64_t a, std::int64_t b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

}  // namespace

DepthCounter::DepthCounter(const Camera& camera, float tanHalfFov, int size)
    : position_(camera.position),
      forward_(glm::normalize(camera.target - camera.position)),
      nearPlane_(camera.nearPlane),
      pixelsPerUnit_(0.5F * static_cast<float>(size) / tanHalfFov),
      size_(size),
      counts_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {
  right_ = glm::normalize(glm::cross(forward_, camera.up));
  up_ = glm::cross(right_, forward_);
}

void DepthCounter::project(const Primitive& mesh, const glm::mat4& transform) {
  corners_.clear();
  const float half = 0.5F * static_cast<float>(size_);
  const float farthest = kFarthestCorner * static_cast<float>(size_);
  const auto snap = [&](float pixels) {
    const float inside = std::clamp(pixels, -farthest, farthest);
    return static_cast<std::int64_t>(std::floor(inside * static_cast<float>(kSubPixels) + 0.5F));
  };
  for (const glm::vec3& p : mesh.positions) {
    const glm::vec3 v = glm::vec3(transform * glm::vec4(p, 1.0F)) - position_;
    const float depth = glm::dot(v, forward_);
    Corner corner;
    if (depth > nearPlane_) {
      corner.visible = true;
      corner.x = snap(half + glm::dot(v, right_) / depth * pixelsPerUnit_);
      corner.y = snap(half - glm::dot(v, up_) / depth * pixelsPerUnit_);
      corner.nearness = 1.0F / depth;
    }
    corners_.push_back(corner);
  }
}

void DepthCounter::occlude(const Primitive& mesh, const glm::mat4& transform) {
  if (occluder_.empty()) occluder_.assign(counts_.size(), 0.0F);
  project(mesh, transform);
  draw(mesh, [&](std::size_t pixel, float nearness) {
    occluder_[pixel] = std::max(occluder_[pixel], nearness);
  });
}

bool DepthCounter::addWithin(const Primitive& mesh, const glm::mat4& transform, int limit) {
  drawn_.clear();
  project(mesh, transform);
  draw(mesh, [&](std::size_t pixel, float nearness) {
    if (!occluder_.empty() && nearness <= occluder_[pixel]) return;
    ++counts_[pixel];
    drawn_.push_back(pixel);
  });
  const bool fits = std::all_of(drawn_.begin(), drawn_.end(),
                                [&](std::size_t pixel) { return counts_[pixel] <= limit; });
  if (!fits) {
    for (const std::size_t pixel : drawn_) --counts_[pixel];
  }
  return fits;
}

float DepthCounter::coverage() const {
  const auto empty = std::count(counts_.begin(), counts_.end(), std::uint16_t{0});
  return 1.0F - static_cast<float>(empty) / static_cast<float>(counts_.size());
}

template <typename Visit>
void DepthCounter::draw(const Primitive& mesh, const Visit& visit) const {
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::array<Corner, 3> c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = corners_[mesh.indices[i + k]];
    if (c[0].visible && c[1].visible && c[2].visible) drawTriangle(c, visit);
  }
}

template <typename Visit>
void DepthCounter::drawTriangle(const std::array<Corner, 3>& corners, const Visit& visit) const {
  std::array<Corner, 3> c = corners;
  const std::int64_t area =
      (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);
  if (area == 0) return;
  if (area < 0) std::swap(c[1], c[2]);  // now clockwise on the screen, where y points down
  const float perArea = 1.0F / static_cast<float>(std::abs(area));
  const auto [minX, maxX] = std::minmax({c[0].x, c[1].x, c[2].x});
  const auto [minY, maxY] = std::minmax({c[0].y, c[1].y, c[2].y});
  const std::int64_t last = size_ - 1;
  const std::int64_t x0 = std::max<std::int64_t>(floorDivide(minX, kSubPixels), 0);
  const std::int64_t x1 = std::min<std::int64_t>(floorDivide(maxX, kSubPixels), last);
  const std::int64_t y0 = std::max<std::int64_t>(floorDivide(minY, kSubPixels), 0);
  const std::int64_t y1 = std::min<std::int64_t>(floorDivide(maxY, kSubPixels), last);
  // Edge functions at the first pixel centre and their steps from pixel to pixel; less one where a
  // centre on the edge belongs to the neighbour, so that inside means no value is below zero.
  std::array<Edge, 3> edges;
  for (std::size_t e = 0; e < 3; ++e) {
    const Corner& a = c[e];
    const Corner& b = c[(e + 1) % 3];
    const std::int64_t px = x0 * kSubPixels + kSubPixels / 2;
    const std::int64_t py = y0 * kSubPixels + kSubPixels / 2;
    const bool topLeft = (a.y == b.y && b.x > a.x) || b.y < a.y;
    edges[e].row = (b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x) - (topLeft ? 0 : 1);
    edges[e].stepX = -(b.y - a.y) * kSubPixels;
    edges[e].stepY = (b.x - a.x) * kSubPixels;
  }
  for (std::int64_t y = y0; y <= y1; ++y) {
    std::int64_t e0 = edges[0].row;
    std::int64_t e1 = edges[1].row;
    std::int64_t e2 = edges[2].row;
    bool entered = false;
    for (std::int64_t x = x0; x <= x1; ++x) {
      const bool inside = (e0 | e1 | e2) >= 0;  // no sign bit in any of them
      // Each edge function is the weight of the corner across from it.
      const float nearness = c[2].nearness * static_cast<float>(e0) * perArea +
                             c[0].nearness * static_cast<float>(e1) * perArea +
                             c[1].nearness * static_cast<float>(e2) * perArea;
      e0 += edges[0].stepX;
      e1 += edges[1].stepX;
      e2 += edges[2].stepX;
      if (!inside) {
        if (entered) break;  // a triangle is convex: its row is one run
        continue;
      }
      entered = true;
      visit(static_cast<std::size_t>(y * size_ + x), nearness);
    }
    for (Edge& edge : edges) edge.row += edge.stepY;
  }
}

}  // namespace macula::scene
