// LDR-FLIP: the difference that a viewer sees when two images alternate.
//
// This work is based on: P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom,
// M. D. Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM Comput. Graph.
// Interact. Tech. 3(2), 2020. Section and equation names in flip.cpp are those of that paper.
#pragma once

#include <cstddef>

#include "engine/image/image.h"
#include "engine/measure/filter.h"

namespace macula::measure {

/// The paper's viewing condition: 3840 pixels on a monitor 0.70 m wide, seen from 0.70 m:
/// 0.70 * 3840 / 0.70 * pi / 180.
inline constexpr double kDefaultPixelsPerDegree = 67.0206;

/// R, G or B (0..2) of a pixel; a grey image's one value for each.
[[nodiscard]] inline float colourAt(const image::ImageF& image, std::size_t pixel, int channel) {
  const auto channels = static_cast<std::size_t>(image.channels);
  return image.pixels[pixel * channels + (channels < 3 ? 0 : static_cast<std::size_t>(channel))];
}

/// The FLIP error of every pixel, 0 (none) to 1. Values are clamped to 0..1 and taken as
/// sRGB-encoded, or as they are where an image is linear; alpha is left out.
/// @param pixelsPerDegree of visual angle, 1..1000
/// @throws InputError where sizes differ, an image is empty or pixelsPerDegree is out of range.
[[nodiscard]] Plane flipMap(const image::ImageF& reference, const image::ImageF& test,
                            double pixelsPerDegree = kDefaultPixelsPerDegree);

/// The mean of a map.
[[nodiscard]] double meanOf(const Plane& map);

/// The mean of flipMap().
[[nodiscard]] double flipMean(const image::ImageF& reference, const image::ImageF& test,
                              double pixelsPerDegree = kDefaultPixelsPerDegree);

}  // namespace macula::measure
