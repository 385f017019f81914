// Images of where two images differ.
#pragma once

#include "engine/image/image.h"
#include "engine/measure/filter.h"

namespace macula::measure {

/// |test - reference| of R, G and B times `scale`, as PNG bytes.
struct DifferenceMap {
  image::Image8 image;
  double scale = 1.0;  ///< the largest power of two that clips no value; 1 for equal images
};

/// The images have one size.
[[nodiscard]] DifferenceMap differenceMap(const image::ImageF& reference,
                                          const image::ImageF& test);

/// FLIP values 0..1 in the magma colour map, as the authors of FLIP show them: black where nothing
/// is seen, light yellow for the largest difference.
[[nodiscard]] image::Image8 flipImage(const Plane& map);

}  // namespace macula::measure
