#include "engine/measure/filter.h"

#include <algorithm>
#include <cstddef>

namespace macula::measure {
namespace {

/// out += weight * in. Kept plain, so that compilers make vector code of it.
void addScaled(float* out, const float* in, float weight, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) out[i] += weight * in[i];
}

}  // namespace

Plane filterRows(const Plane& plane, std::span<const float> weights) {
  Plane result(plane.width, plane.height);
  const auto width = static_cast<std::size_t>(plane.width);
  const std::size_t radius = weights.size() / 2;
  std::vector<float> padded(width + 2 * radius);
  for (std::size_t row = 0; row < static_cast<std::size_t>(plane.height); ++row) {
    const float* in = plane.values.data() + row * width;
    std::fill_n(padded.begin(), radius, in[0]);
    std::copy_n(in, width, padded.data() + radius);
    std::fill_n(padded.data() + radius + width, radius, in[width - 1]);
    float* out = result.values.data() + row * width;
    for (std::size_t tap = 0; tap < weights.size(); ++tap) {
      addScaled(out, padded.data() + tap, weights[tap], width);
    }
  }
  return result;
}

Plane filterColumns(const Plane& plane, std::span<const float> weights) {
  Plane result(plane.width, plane.height);
  const auto width = static_cast<std::size_t>(plane.width);
  const int radius = static_cast<int>(weights.size() / 2);
  for (int row = 0; row < plane.height; ++row) {
    float* out = result.values.data() + static_cast<std::size_t>(row) * width;
    for (int tap = -radius; tap <= radius; ++tap) {
      const auto source = static_cast<std::size_t>(std::clamp(row + tap, 0, plane.height - 1));
      addScaled(out, plane.values.data() + source * width,
                weights[static_cast<std::size_t>(tap + radius)], width);
    }
  }
  return result;
}

Plane filterSeparable(const Plane& plane, std::span<const float> across,
                      std::span<const float> down) {
  return filterColumns(filterRows(plane, across), down);
}

}  // namespace macula::measure
