#include "network_mirror.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "shared/network.h"

namespace macula::test {
namespace {

/// Of a reversed depth: 1 at the near plane, 0 at the far one.
double distanceOf(float depth, const scene::Camera& camera) {
  const double nearPlane = static_cast<double>(camera.nearPlane);
  const double farPlane = static_cast<double>(camera.farPlane);
  return nearPlane * farPlane / (nearPlane + static_cast<double>(depth) * (farPlane - nearPlane));
}

double opticalDepth(double alpha) {
  constexpr double kMost = 8.0;
  return std::min(kMost, -std::log2(std::max(1.0 - alpha, std::exp2(-kMost))));
}

glm::dvec3 squaredShown(glm::dvec3 radiance) {
  return glm::clamp(radiance, 0.0, 1.0);
}

glm::dvec3 shown(glm::dvec3 radiance) {
  return glm::sqrt(squaredShown(radiance));
}

glm::dvec3 meanOf(glm::dvec3 tauColor, double tau) {
  return glm::max(tauColor, 0.0) / std::max(tau, 1e-6);
}

}  // namespace

MirrorFrame frameOf(const Bench& exact, const Bench& opaque) {
  const glm::ivec2 size = exact.renderer.outputSize();
  const auto width = static_cast<std::size_t>(size.x);
  const auto height = static_cast<std::size_t>(size.y);
  const auto ranges = exact.words(passes::kFragmentRange, 2);
  const auto keys = exact.bufferWords(passes::kFragmentKeys);
  const auto colors = exact.bufferWords(passes::kFragmentColors);
  const auto behind = opaque.floats(passes::kHdrColor, 4);
  // What was drawn, whose planes may be others than the scene's camera asks for.
  const scene::Camera& camera = exact.renderer.inputs().view.camera;
  MirrorFrame frame;
  frame.size = size;
  frame.farPlane = static_cast<double>(camera.farPlane);
  frame.pixels.resize(width * height);
  frame.behind.resize(width * height);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t texel = y * width + x;  // rows from the bottom
      const std::size_t pixel = (height - 1 - y) * width + x;
      frame.behind[pixel] = {behind[4 * texel], behind[4 * texel + 1], behind[4 * texel + 2]};
      for (std::size_t i = 0; i < ranges[2 * texel + 1]; ++i) {
        const std::size_t at = 2 * (ranges[2 * texel] + i);
        const glm::vec4 color(glm::unpackHalf2x16(colors[at]), glm::unpackHalf2x16(colors[at + 1]));
        frame.pixels[pixel].push_back(
            {distanceOf(std::bit_cast<float>(~keys[at]), camera), glm::dvec4(color)});
      }
      std::stable_sort(frame.pixels[pixel].begin(), frame.pixels[pixel].end(),
                       [](const auto& a, const auto& b) { return a.distance < b.distance; });
    }
  }
  return frame;
}

std::vector<std::array<double, 12>> thesisFeatures(const MirrorFrame& frame, std::uint64_t slots) {
  double fragments = 0.0;
  double covered = 0.0;
  double nearest = frame.farPlane;
  double farthest = 0.0;
  for (const auto& pixel : frame.pixels) {
    if (pixel.empty()) continue;
    fragments += static_cast<double>(pixel.size());
    covered += 1.0;
    nearest = std::min(nearest, pixel.front().distance);
    farthest = std::max(farthest, pixel.back().distance);
  }
  std::vector<std::array<double, 12>> all(frame.pixels.size());
  for (std::size_t p = 0; p < all.size(); ++p) {
    const auto& pixel = frame.pixels[p];
    if (pixel.empty()) continue;
    const auto n = static_cast<double>(pixel.size());
    glm::dvec3 sum(0.0);
    for (const MirrorFragment& fragment : pixel) sum += glm::dvec3(fragment.color);
    const glm::dvec4& front = pixel.front().color;
    all[p] = {n / fragments * covered,
              static_cast<double>(slots) / fragments,
              pixel.front().distance / frame.farPlane,
              pixel.back().distance / frame.farPlane,
              nearest / frame.farPlane,
              farthest / frame.farPlane,
              sum.r / n,
              sum.g / n,
              sum.b / n,
              front.r,
              front.g,
              front.b};
  }
  return all;
}

MirrorSlices slicesOf(const std::vector<MirrorFragment>& fragments, bool fixedPoint) {
  constexpr double kSteps = 1024.0;
  const auto stepped = [&](double value) {
    return fixedPoint ? std::floor(value * kSteps + 0.5) / kSteps : value;
  };
  MirrorSlices result;
  const double nearest = fragments.front().distance;
  const double depth = fragments.back().distance - nearest;
  for (const MirrorFragment& fragment : fragments) {
    const double way = depth > 0.0 ? (fragment.distance - nearest) / depth : 0.0;
    const double place = LEARNED_SLICES * 2.0 * way / (1.0 + way);
    const auto index = static_cast<std::size_t>(std::min(std::floor(place), LEARNED_SLICES - 1.0));
    // The nearest and the farthest stand at the ends for certain.
    for (int boundary = 1; boundary < LEARNED_SLICES; ++boundary) {
      result.nearestBoundary = std::min(result.nearestBoundary, std::abs(place - boundary));
    }
    MirrorSlice& slice = result.slices[index];
    const double tau = opticalDepth(fragment.color.a);
    slice.fragments += 1.0;
    slice.tau += stepped(tau);
    for (int c = 0; c < 3; ++c) {
      slice.tauColor[c] += stepped(tau * fragment.color[c] / std::max(fragment.color.a, 1e-6));
    }
  }
  return result;
}

std::array<double, LEARNED_FEATURES> plainLearnedFeatures(const MirrorSlices& of,
                                                          glm::dvec3 behind) {
  MirrorSlice all;
  glm::dvec3 color(0.0);
  for (const MirrorSlice& slice : of.slices) {
    const double before = std::exp2(-all.tau);
    all.fragments += slice.fragments;
    all.tau += slice.tau;
    all.tauColor += slice.tauColor;
    color += (before - std::exp2(-all.tau)) * meanOf(slice.tauColor, slice.tau);
  }
  const double passes = std::exp2(-all.tau);
  const glm::dvec3 exact = shown(color + passes * behind);
  std::array<double, LEARNED_FEATURES> x{};
  x[0] = all.fragments;
  MirrorSlice kept;
  glm::dvec3 keptColor(0.0);
  for (std::size_t i = 0; i < of.slices.size(); ++i) {
    const MirrorSlice& slice = of.slices[i];
    // This slice and those behind it become one layer of their mean colour.
    const double reaches = std::exp2(-kept.tau);
    const glm::dvec3 mean = meanOf(all.tauColor - kept.tauColor, all.tau - kept.tau);
    const glm::dvec3 off = exact - shown(keptColor + (reaches - passes) * mean + passes * behind);
    x[1 + i] = glm::dot(off, off);
    kept.tau += slice.tau;
    kept.tauColor += slice.tauColor;
    const glm::dvec3 own = meanOf(slice.tauColor, slice.tau);
    keptColor += (reaches - std::exp2(-kept.tau)) * own;
    x[kPasses + i] = std::exp2(-kept.tau);
    x[kShares + i] = slice.fragments / all.fragments;
    x[kThickness + i] = slice.tau / std::max(slice.fragments, 1.0);
    for (std::size_t c = 0; c < 3; ++c) {
      x[kColors + 3 * i + c] = squaredShown(own)[static_cast<int>(c)];
    }
  }
  for (std::size_t c = 0; c < 3; ++c) x[kBehind + c] = squaredShown(behind)[static_cast<int>(c)];
  return x;
}

std::array<double, LEARNED_FEATURES> plainOf(const float* first) {
  std::array<double, LEARNED_FEATURES> x{};
  std::copy_n(first, x.size(), x.begin());
  x[0] = std::exp2(x[0]);
  for (std::size_t i = 0; i < LEARNED_SLICES; ++i) {
    x[1 + i] = std::exp2(x[1 + i]) - LEARNED_LEAST_ERROR;
    x[kThickness + i] = std::exp2(x[kThickness + i]) - LEARNED_LEAST_DEPTH;
  }
  for (std::size_t i = kColors; i < x.size(); ++i) x[i] *= x[i];
  return x;
}

double outputBetween(const std::vector<double>& values, const std::vector<double>& covered,
                     glm::ivec2 tiles, int tile, glm::ivec2 pixel) {
  double sum = 0.0;
  double weights = 0.0;
  // Every tile weighs by how close its middle is, one tile away nothing; those at the edge stand
  // for those beyond it.
  for (int y = -1; y <= tiles.y; ++y) {
    for (int x = -1; x <= tiles.x; ++x) {
      const double dx = std::abs((pixel.x + 0.5) / tile - (x + 0.5));
      const double dy = std::abs((pixel.y + 0.5) / tile - (y + 0.5));
      if (dx >= 1.0 || dy >= 1.0) continue;
      const glm::ivec2 at = glm::clamp(glm::ivec2(x, y), glm::ivec2(0), tiles - 1);
      const auto i = static_cast<std::size_t>(at.y * tiles.x + at.x);
      const double weight = covered[i] > 0.0 ? (1.0 - dx) * (1.0 - dy) : 0.0;
      sum += weight * values[i];
      weights += weight;
    }
  }
  return sum / weights;
}

}  // namespace macula::test
