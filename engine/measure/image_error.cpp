#include "engine/measure/image_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/measure/gaze_weight.h"
#include "engine/measure/hdr_flip.h"
#include "engine/measure/srgb.h"

namespace macula::measure {
namespace {

using image::ImageF;

void requireComparable(const ImageF& reference, const ImageF& test) {
  if (reference.width != test.width || reference.height != test.height) {
    failInput("the reference is {} x {} pixels and the test {} x {}; compare images of one size",
              reference.width, reference.height, test.width, test.height);
  }
  if (reference.width < 1 || reference.height < 1) failInput("the images to compare are empty");
}

[[noreturn]] void failNotFinite(const ImageF& image, std::size_t pixel, const char* which) {
  const auto width = static_cast<std::size_t>(image.width);
  failInput("the {} image holds a value that is not finite at pixel {},{}; render it again", which,
            pixel % width, pixel / width);
}

}  // namespace

Comparison compareWithMap(const ImageF& reference, const ImageF& test,
                          const CompareOptions& options) {
  requireComparable(reference, test);
  const std::size_t pixels =
      static_cast<std::size_t>(reference.width) * static_cast<std::size_t>(reference.height);
  Comparison result;
  ImageError& error = result.error;
  double squares = 0.0;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    for (int channel = 0; channel < 3; ++channel) {
      const double wanted = colourAt(reference, pixel, channel);
      const double got = colourAt(test, pixel, channel);
      if (!std::isfinite(wanted)) failNotFinite(reference, pixel, "reference");
      if (!std::isfinite(got)) failNotFinite(test, pixel, "test");
      const double difference = std::abs(got - wanted);
      squares += difference * difference;
      error.max = std::max(error.max, difference);
    }
  }
  const double meanSquare = squares / (3.0 * static_cast<double>(pixels));
  error.rmse = std::sqrt(meanSquare);
  if (meanSquare > 0.0) error.psnrDb = -10.0 * std::log10(meanSquare);
  if (!options.flip) return result;
  result.flipMap = options.hdr ? hdrFlipMap(reference, test, options.pixelsPerDegree)
                               : flipMap(reference, test, options.pixelsPerDegree);
  error.flip = meanOf(*result.flipMap);
  if (options.gaze) {
    error.flipGaze = gazeWeightedMean(*result.flipMap, *options.gaze, options.pixelsPerDegree);
  }
  return result;
}

ImageError compareImages(const ImageF& reference, const ImageF& test,
                         const CompareOptions& options) {
  return compareWithMap(reference, test, options).error;
}

ImageF toDisplay(const ImageF& linear) {
  ImageF display = linear;
  display.linear = false;
  const auto channels = static_cast<std::size_t>(linear.channels);
  const bool hasAlpha = channels == 2 || channels == 4;
  for (std::size_t i = 0; i < display.pixels.size(); ++i) {
    if (hasAlpha && i % channels == channels - 1) continue;
    float& value = display.pixels[i];
    value = encodeSrgb(std::clamp(value, 0.0F, 1.0F));  // of NaN, std::clamp gives NaN
  }
  return display;
}

nlohmann::json toJson(const ImageError& error) {
  const auto orNull = [](const std::optional<double>& number) {
    return number ? nlohmann::json(*number) : nlohmann::json(nullptr);
  };
  nlohmann::json json{{"rmse", error.rmse},
                      {"psnr_db", orNull(error.psnrDb)},
                      {"max", error.max},
                      {"flip", orNull(error.flip)}};
  if (error.flipGaze) json["flip_gaze"] = *error.flipGaze;
  return json;
}

}  // namespace macula::measure
