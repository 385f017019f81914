// Separable filters on single-channel images.
#pragma once

#include <span>
#include <vector>

namespace macula::measure {

/// One channel, rows from the top.
struct Plane {
  Plane(int w, int h) : width(w), height(h), values(count(w, h)) {}

  int width;
  int height;
  std::vector<float> values;  ///< width * height

 private:
  static std::size_t count(int w, int h) {
    return static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
  }
};

/// Correlates rows with `across` and the result's columns with `down`. Both have odd length and are
/// centred; beyond the border the nearest pixel goes on.
[[nodiscard]] Plane filterSeparable(const Plane& plane, std::span<const float> across,
                                    std::span<const float> down);

/// The two halves of filterSeparable(), for filters that share one.
[[nodiscard]] Plane filterRows(const Plane& plane, std::span<const float> weights);
[[nodiscard]] Plane filterColumns(const Plane& plane, std::span<const float> weights);

}  // namespace macula::measure
