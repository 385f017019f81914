// Images of where two images differ.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/image/image.h"
#include "engine/measure/filter.h"

namespace macula::measure {

/// |test - reference| of R, G and B times `scale`, as PNG bytes.
struct DifferenceMap {
  image::Image8 image;
  double scale = 1.0;  ///< 1 / white; 1 for equal images
  double white = 0.0;  ///< the difference shown as 255, as larger ones are; 0 for equal images
};

/// The images have one size.
/// @param scale fixes the scale; without it, white is the 99th percentile (nearest rank) of the
///   differences that are not 0, so that a few bright pixels do not hide the others, and a few
///   wrong pixels are not hidden by all the right ones
[[nodiscard]] DifferenceMap differenceMap(const image::ImageF& reference, const image::ImageF& test,
                                          std::optional<double> scale = {});

/// An SVG with the colour bars of a difference map and of a FLIP map.
/// @param white of the DifferenceMap @param unit of the differences, "display values, 0 to 1"
[[nodiscard]] std::string colourBars(double white, std::string_view unit);

/// FLIP values 0..1 in the magma colour map, as the authors of FLIP show them: black where nothing
/// is seen, light yellow for the largest difference.
[[nodiscard]] image::Image8 flipImage(const Plane& map);

}  // namespace macula::measure
