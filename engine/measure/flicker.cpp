#include "engine/measure/flicker.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/core/error.h"
#include "engine/measure/flip.h"

namespace macula::measure {

std::optional<double> FlickerMeter::next(const image::ImageF& reference,
                                         const image::ImageF& test) {
  const bool first = before_.pixels.empty();
  const auto fits = [&](const image::ImageF& other) {
    return other.width == reference.width && other.height == reference.height;
  };
  if (!fits(test) || (!first && !fits(before_))) {
    failInput("flicker needs frames of one size; these are {} x {} and {} x {}", reference.width,
              reference.height, test.width, test.height);
  }
  image::ImageF now{reference.width, reference.height, 3, {}};
  const std::size_t pixels =
      static_cast<std::size_t>(reference.width) * static_cast<std::size_t>(reference.height);
  now.pixels.reserve(3 * pixels);
  double sum = 0.0;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    for (int channel = 0; channel < 3; ++channel) {
      const float difference = colourAt(test, pixel, channel) - colourAt(reference, pixel, channel);
      if (!first)
        sum += std::abs(static_cast<double>(difference) - before_.pixels[now.pixels.size()]);
      now.pixels.push_back(difference);
    }
  }
  before_ = std::move(now);
  if (first || pixels == 0) return std::nullopt;
  return sum / (3.0 * static_cast<double>(pixels));
}

}  // namespace macula::measure
