#include "engine/measure/error_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/measure/flip.h"

namespace macula::measure {
namespace {

/// Every 15th of the 256 colours of magma (van der Walt & Smith 2015), 0xRRGGBB, sRGB-encoded.
/// Mixed linearly in between they stay within 3 of 255 of the others.
constexpr std::array<std::uint32_t, 18> kMagma = {
    0x000004, 0x090720, 0x1A1042, 0x311165, 0x4A1079, 0x621980, 0x792282, 0x912B81, 0xAA337D,
    0xC23B75, 0xD9466B, 0xEC5860, 0xF7725C, 0xFC8E64, 0xFEAA74, 0xFEC68A, 0xFDE2A3, 0xFCFDBF};

/// The byte of a colour at `shift` bits.
float channelOf(std::uint32_t colour, unsigned shift) {
  return static_cast<float>((colour >> shift) & 0xFFU);
}

}  // namespace

DifferenceMap differenceMap(const image::ImageF& reference, const image::ImageF& test) {
  const std::size_t pixels =
      static_cast<std::size_t>(reference.width) * static_cast<std::size_t>(reference.height);
  image::ImageF differences{reference.width, reference.height, 3, {}};
  differences.pixels.reserve(3 * pixels);
  float largest = 0.0F;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    for (int channel = 0; channel < 3; ++channel) {
      const float difference =
          std::abs(colourAt(test, pixel, channel) - colourAt(reference, pixel, channel));
      largest = std::max(largest, difference);
      differences.pixels.push_back(difference);
    }
  }
  DifferenceMap map;
  if (largest > 0.0F) map.scale = std::exp2(std::floor(-std::log2(static_cast<double>(largest))));
  for (float& value : differences.pixels) value *= static_cast<float>(map.scale);
  map.image = image::toImage8(differences);
  return map;
}

image::Image8 flipImage(const Plane& map) {
  image::Image8 image{map.width, map.height, 3, {}};
  image.pixels.reserve(3 * map.values.size());
  for (const float value : map.values) {
    const float place = std::clamp(value, 0.0F, 1.0F) * static_cast<float>(kMagma.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), kMagma.size() - 2);
    const float share = place - static_cast<float>(below);
    for (const unsigned shift : {16U, 8U, 0U}) {
      const float low = channelOf(kMagma[below], shift);
      const float high = channelOf(kMagma[below + 1], shift);
      image.pixels.push_back(static_cast<std::uint8_t>(std::lround(low + share * (high - low))));
    }
  }
  return image;
}

}  // namespace macula::measure
