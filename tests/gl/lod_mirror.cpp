#include "lod_mirror.h"

#include <algorithm>
#include <cmath>

namespace macula::test {
namespace {

constexpr int kTile = 16;
constexpr double kDegrees = 57.29577951308232;

double squared(double x) {
  return x * x;
}

}  // namespace

int samplePixel(int cell, float pitch, int size) {
  const float middle = (static_cast<float>(cell) + 0.5F) * pitch;
  return std::min(static_cast<int>(std::floor(middle)), size - 1);
}

double RateMirror::allowedPitch(glm::dvec2 place) const {
  const glm::dvec2 away = place - gaze;
  const double distance = glm::length(away);
  const glm::dvec2 nearest =
      distance > 0.0 ? gaze + away * (std::max(distance - widened, 0.0) / distance) : gaze;
  const glm::dvec3 a = glm::normalize(glm::dvec3(gaze - 0.5 * size, viewer));
  const glm::dvec3 b = glm::normalize(glm::dvec3(nearest - 0.5 * size, viewer));
  const double eccentricity = std::acos(std::min(1.0, glm::dot(a, b))) * kDegrees;
  return (slope * eccentricity + fovealMar) / kDegrees * viewer / samples;
}

int RateMirror::level(glm::ivec2 tile) const {
  const glm::dvec2 low = glm::dvec2(tile * kTile) * resize;
  const double allowed = allowedPitch(glm::clamp(gaze, low, low + kTile * resize));
  int level = 0;
  while ((2 << level) * resize <= allowed && (2 << level) <= coarsest) ++level;
  return level;
}

double ReconstructionMirror::inverseDistance(float depthValue) const {
  const double n = view.camera.nearPlane;
  const double f = view.camera.farPlane;
  return static_cast<double>(depthValue) * (f - n) / (n * f) + 1.0 / f;
}

glm::dvec3 ReconstructionMirror::rayThrough(glm::ivec2 pixel) const {
  const glm::dmat4 toWorld = glm::inverse(glm::dmat4(view.view));
  const glm::dvec2 ndc = (glm::dvec2(pixel) + 0.5) / glm::dvec2(size) * 2.0 - 1.0;
  const glm::dvec3 seen(ndc.x / static_cast<double>(view.projection[0][0]),
                        ndc.y / static_cast<double>(view.projection[1][1]), -1.0);
  return glm::dvec3(toWorld * glm::dvec4(seen, 0.0));
}

int ReconstructionMirror::levelAt(glm::ivec2 texel) const {
  if (levels.empty()) return 0;
  const glm::ivec2 tile = glm::min(texel, texels - 1) / kTile;
  const int tilesPerRow = (texels.x + kTile - 1) / kTile;
  return levels[static_cast<std::size_t>(tile.y * tilesPerRow + tile.x)];
}

std::array<ReconstructionMirror::Tap, 4> ReconstructionMirror::tapsAround(glm::ivec2 p) const {
  const float inverse = 1.0F / resize;
  const int level = levelAt(glm::ivec2((glm::vec2(p) + 0.5F) * inverse));
  const float pitch = resize * static_cast<float>(1 << level);
  const glm::ivec2 cells = (texels + (1 << level) - 1) / (1 << level);
  glm::ivec2 low{0};
  glm::ivec2 high{0};
  glm::ivec2 from{0};
  glm::ivec2 to{0};
  glm::dvec2 between{0.0};
  for (int axis = 0; axis < 2; ++axis) {
    // The last sample at or before the pixel.
    while (low[axis] + 1 < cells[axis] &&
           samplePixel(low[axis] + 1, pitch, size[axis]) <= p[axis]) {
      ++low[axis];
    }
    high[axis] = std::min(low[axis] + 1, cells[axis] - 1);
    from[axis] = samplePixel(low[axis], pitch, size[axis]);
    to[axis] = samplePixel(high[axis], pitch, size[axis]);
    if (to[axis] > from[axis]) {
      between[axis] =
          std::clamp(static_cast<double>(p[axis] - from[axis]) / (to[axis] - from[axis]), 0.0, 1.0);
    }
  }
  std::array<Tap, 4> taps;
  for (int i = 0; i < 4; ++i) {
    const glm::ivec2 cell((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y);
    const glm::ivec2 place = glm::min(cell * (1 << level) + (1 << level) / 2, texels - 1);
    const int there = levelAt(place);
    const glm::ivec2 found = place / (1 << there);
    const glm::ivec2 texel = found * (1 << there);
    Tap& tap = taps[static_cast<std::size_t>(i)];
    tap.sample = samples[static_cast<std::size_t>(texel.y * samplesPerRow + texel.x)];
    const float pitchThere = resize * static_cast<float>(1 << there);
    tap.pixel = {samplePixel(found.x, pitchThere, size.x),
                 samplePixel(found.y, pitchThere, size.y)};
    tap.tent =
        ((i & 1) != 0 ? between.x : 1.0 - between.x) * ((i & 2) != 0 ? between.y : 1.0 - between.y);
  }
  return taps;
}

double ReconstructionMirror::fitOf(const Tap& tap, glm::ivec2 p) const {
  const auto at = static_cast<std::size_t>(p.y * size.x + p.x);
  // The far plane itself is the background; its inverse was a float.
  const bool surface =
      tap.sample.inverseDistance > static_cast<double>(1.0F / view.camera.farPlane);
  if (depth[at] == 0.0F) return surface ? 0.0 : 1.0;
  if (!surface) return 0.0;
  const double own = inverseDistance(depth[at]);
  const glm::dvec3 n = normal[at];
  if (filter == passes::Reconstruction::Yang2008) {
    const auto slope = [&](const glm::dvec3& world) {
      const glm::dvec3 seen = glm::dmat3(view.view) * world;
      return glm::dvec2(seen) / std::max(seen.z, 1e-3);
    };
    const double across = glm::length(slope(tap.sample.normal) - slope(n));
    // |z_H - z_L| over z_H
    const double z = std::abs(1.0 / own - 1.0 / tap.sample.inverseDistance) * own;
    return std::exp(-0.5 * (squared(across / sigmaNormal) + squared(z / sigmaDepth)));
  }
  // Distance of the tap's point from the tangent plane over what a pixel spans there.
  const glm::dvec3 point = rayThrough(p) / own;
  const glm::dvec3 other = rayThrough(tap.pixel) / tap.sample.inverseDistance;
  const double pixelSpan =
      2.0 / static_cast<double>(view.projection[1][1]) / size.y / tap.sample.inverseDistance;
  const glm::ivec2 offset = glm::abs(tap.pixel - p);
  const double reach = std::max(offset.x, offset.y);
  const double plane = std::abs(glm::dot(n, other - point)) / pixelSpan / (0.25 + 0.1 * reach);
  const double bend = (1.0 - glm::dot(n, tap.sample.normal)) / 0.015;
  return 1.0 / squared(1.0 + squared(plane) + squared(bend));
}

ReconstructionMirror::Outcome ReconstructionMirror::pixel(glm::ivec2 p) const {
  Outcome outcome;
  double weights = 0.0;
  const std::array<Tap, 4> taps = tapsAround(p);
  for (const Tap& tap : taps) {
    const double fit = filter == passes::Reconstruction::Bilinear ? 1.0 : fitOf(tap, p);
    if (tap.tent > 0.0) outcome.best = std::max(outcome.best, fit);
    weights += tap.tent * fit;
    outcome.value += tap.tent * fit * tap.sample.value;
  }
  outcome.value /= weights;
  return outcome;
}

}  // namespace macula::test
