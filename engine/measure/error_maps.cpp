#include "engine/measure/error_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

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

/// See differenceMap().
constexpr double kWhiteShare = 0.99;

double whiteOf(const std::vector<float>& differences) {
  std::vector<float> some;
  std::ranges::copy_if(differences, std::back_inserter(some), [](float v) { return v > 0.0F; });
  if (some.empty()) return 0.0;
  const auto rank = std::ceil(kWhiteShare * static_cast<double>(some.size()));
  const auto place = some.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
  std::ranges::nth_element(some, place);
  return *place;
}

/// A bar with texts at both ends, as SVG. stops: of the gradient
std::string barOf(int top, std::string_view name, std::string_view stops, std::string_view low,
                  std::string_view high) {
  return fmt::format(
      "<linearGradient id='{0}'>{1}</linearGradient>\n<text x='10' y='{2}'>{3}</text>"
      "<rect x='140' y='{4}' width='260' height='18' stroke='gray' fill='url(#{0})'/>"
      "<text x='410' y='{2}'>{5}</text>\n",
      name, stops, top + 14, low, top, high);
}

}  // namespace

DifferenceMap differenceMap(const image::ImageF& reference, const image::ImageF& test,
                            std::optional<double> scale) {
  const std::size_t pixels =
      static_cast<std::size_t>(reference.width) * static_cast<std::size_t>(reference.height);
  image::ImageF differences{reference.width, reference.height, 3, {}};
  differences.pixels.reserve(3 * pixels);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    for (int channel = 0; channel < 3; ++channel) {
      const float difference =
          std::abs(colourAt(test, pixel, channel) - colourAt(reference, pixel, channel));
      differences.pixels.push_back(difference);
    }
  }
  DifferenceMap map;
  map.white = whiteOf(differences.pixels);
  if (map.white > 0.0 && scale) map.white = 1.0 / *scale;
  if (map.white > 0.0) map.scale = 1.0 / map.white;
  for (float& value : differences.pixels) {
    value = std::min(1.0F, static_cast<float>(value * map.scale));
  }
  map.image = image::toImage8(differences);
  return map;
}

std::string colourBars(double white, std::string_view unit) {
  std::string magma;
  for (std::size_t i = 0; i < kMagma.size(); ++i) {
    magma +=
        fmt::format("<stop offset='{:.4f}' stop-color='#{:06x}'/>",
                    static_cast<double>(i) / static_cast<double>(kMagma.size() - 1), kMagma[i]);
  }
  constexpr std::string_view kGrey =
      "<stop offset='0' stop-color='#000'/><stop offset='1' stop-color='#fff'/>";
  return "<svg xmlns='http://www.w3.org/2000/svg' width='780' height='70'"
         " font-family='sans-serif' font-size='13'><rect width='780' height='70' fill='#fff'/>\n" +
         (white > 0.0 ? barOf(10, "difference", kGrey, "difference 0",
                              fmt::format("{:.4g} and more ({})", white, unit))
                      : std::string("<text x='10' y='24'>no difference</text>\n")) +
         barOf(42, "flip", magma, "FLIP 0", "1: the largest difference") + "</svg>\n";
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
