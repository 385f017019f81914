#include "engine/measure/hdr_flip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace macula::measure {
namespace {

using image::ImageF;

/// The curve (a x^2 + b x) / (d x^2 + e x + f); Narkowicz's fit expects 0.6 of the exposure.
constexpr double kFitExposure = 0.6;
constexpr double kA = kFitExposure * kFitExposure * 2.51;
constexpr double kB = kFitExposure * 0.03;
constexpr double kD = kFitExposure * kFitExposure * 2.43;
constexpr double kE = kFitExposure * 0.59;
constexpr double kF = 0.14;

/// The display value to which start and stop bring their luminances.
constexpr double kTarget = 0.85;
/// Half-floats span 40 stops; below 24 under its brightest an image is black on every display. This
/// bounds the time where the median is next to nothing.
constexpr double kMostStops = 24.0;

/// Luminance of linear sRGB (IEC 61966-2-1).
double luminance(const ImageF& image, std::size_t pixel) {
  constexpr double kWeights[] = {0.2126, 0.7152, 0.0722};
  double sum = 0.0;
  for (int c = 0; c < 3; ++c) {
    sum += kWeights[c] * std::max(0.0, static_cast<double>(colourAt(image, pixel, c)));
  }
  return sum;
}

/// The linear value that the curve brings to kTarget: the positive root of
/// (a - t d) x^2 + (b - t e) x - t f = 0.
double valueAtTarget() {
  const double a = kA - kTarget * kD;
  const double b = kB - kTarget * kE;
  const double c = -kTarget * kF;
  return (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

/// Of sorted values: the middle one, or the mean of the middle two.
double middle(std::span<const double> sorted) {
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

ImageF exposed(const ImageF& image, double stops) {
  ImageF result = image;
  result.linear = true;
  const float scale = static_cast<float>(std::exp2(stops));
  for (float& value : result.pixels) value = toneMapAces(scale * value);
  return result;
}

}  // namespace

float toneMapAces(float linear) {
  const double x = std::max(0.0, static_cast<double>(linear));
  return static_cast<float>(std::clamp(x * (kA * x + kB) / (x * (kD * x + kE) + kF), 0.0, 1.0));
}

Exposures exposuresOf(const ImageF& reference) {
  const std::size_t pixels =
      static_cast<std::size_t>(reference.width) * static_cast<std::size_t>(reference.height);
  std::vector<double> sorted(pixels);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) sorted[pixel] = luminance(reference, pixel);
  std::sort(sorted.begin(), sorted.end());
  if (sorted.empty() || sorted.back() <= 0.0) return {};
  double median = middle(sorted);
  if (median <= 0.0) {
    median = middle({std::upper_bound(sorted.begin(), sorted.end(), 0.0), sorted.end()});
  }
  Exposures exposures;
  exposures.start = std::log2(valueAtTarget() / sorted.back());
  exposures.stop = std::min(std::log2(valueAtTarget() / median), exposures.start + kMostStops);
  if (exposures.stop > exposures.start) {
    exposures.count = std::max(2, static_cast<int>(std::ceil(exposures.stop - exposures.start)));
  }
  return exposures;
}

Plane hdrFlipMap(const ImageF& reference, const ImageF& test, double pixelsPerDegree) {
  const Exposures exposures = exposuresOf(reference);
  const double step =
      exposures.count > 1 ? (exposures.stop - exposures.start) / (exposures.count - 1) : 0.0;
  Plane worst(reference.width, reference.height);
  for (int i = 0; i < exposures.count; ++i) {
    const double stops = exposures.start + i * step;
    const Plane map = flipMap(exposed(reference, stops), exposed(test, stops), pixelsPerDegree);
    for (std::size_t pixel = 0; pixel < worst.values.size(); ++pixel) {
      worst.values[pixel] = std::max(worst.values[pixel], map.values[pixel]);
    }
  }
  return worst;
}

}  // namespace macula::measure
