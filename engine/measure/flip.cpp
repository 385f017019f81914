#include "engine/measure/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "engine/core/error.h"
#include "engine/measure/colour_space.h"
#include "engine/measure/srgb.h"

namespace macula::measure {
namespace {

using image::ImageF;
using Kernel = std::vector<float>;

// Section 4.1.1, Table 1: contrast sensitivity as Gaussians a sqrt(pi / b) exp(-pi^2 x^2 / b), x in
// degrees. Achromatic and red-green have one, blue-yellow is a sum of two.
struct Sensitivity {
  double a;
  double b;
};
constexpr std::array<Sensitivity, 1> kAchromatic = {{{1.0, 0.0047}}};
constexpr std::array<Sensitivity, 1> kRedGreen = {{{1.0, 0.0053}}};
constexpr std::array<Sensitivity, 2> kBlueYellow = {{{34.1, 0.04}, {13.5, 0.025}}};
/// The widest of them, from which all take their radius.
constexpr double kWidest = 0.04;
/// Kernels are cut off after three standard deviations (4.1.1, 4.2).
constexpr double kDeviations = 3.0;

// Section 4.1.3: the Hunt effect scales a* and b* by 0.01 L*.
constexpr float kHunt = 0.01F;
// Section 4.1.4: errors are raised to q_c; those below p_c of the largest take the range 0..p_t.
constexpr float kColourExponent = 0.7F;
constexpr float kKneeShare = 0.4F;
constexpr float kKneeValue = 0.95F;

// Section 4.2: width of the feature kernels in degrees (Kelly's half peak, 0.082), of which half is
// the standard deviation, and the exponent q_f.
constexpr double kFeatureWidth = 0.082;
constexpr float kFeatureExponent = 0.5F;

/// Above this, kernels would be wider than images; below, narrower than their own exponentials.
constexpr double kMinPixelsPerDegree = 1.0;
constexpr double kMaxPixelsPerDegree = 1000.0;

std::size_t pixelCount(const ImageF& image) {
  return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

/// weight(i) for i = -radius .. radius.
template <typename Weight>
std::vector<double> sample(int radius, Weight weight) {
  std::vector<double> kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(weight(static_cast<double>(i)));
  return kernel;
}

double sumOf(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

Kernel scaled(std::span<const double> kernel, double factor) {
  Kernel result;
  for (const double weight : kernel) result.push_back(static_cast<float>(weight * factor));
  return result;
}

/// Filters a channel with the sum of its Gaussians, normalised to weight 1 over the square window.
/// Each Gaussian is separable, their sum is not.
Plane filterSensitivity(const Plane& channel, std::span<const Sensitivity> gaussians, double ppd) {
  using std::numbers::pi;
  const int radius =
      static_cast<int>(std::ceil(kDeviations * std::sqrt(kWidest / (2.0 * pi * pi)) * ppd));
  std::vector<std::vector<double>> kernels;
  std::vector<double> weights;
  double total = 0.0;
  for (const auto& [a, b] : gaussians) {
    const double width = b;
    kernels.push_back(sample(radius, [&](double i) {
      const double degrees = i / ppd;
      return std::exp(-pi * pi * degrees * degrees / width);
    }));
    weights.push_back(a * std::sqrt(pi / b));
    const double side = sumOf(kernels.back());
    total += weights.back() * side * side;
  }
  Plane result(channel.width, channel.height);
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    const Plane part =
        filterSeparable(channel, scaled(kernels[i], 1.0), scaled(kernels[i], weights[i] / total));
    for (std::size_t p = 0; p < part.values.size(); ++p) result.values[p] += part.values[p];
  }
  return result;
}

/// The image in YyCxCz, one plane a channel.
std::array<Plane, 3> toYcxcz(const ImageF& image) {
  std::array<Plane, 3> planes = {Plane(image.width, image.height), Plane(image.width, image.height),
                                 Plane(image.width, image.height)};
  for (std::size_t pixel = 0; pixel < pixelCount(image); ++pixel) {
    Triple rgb{};
    for (int c = 0; c < 3; ++c) {
      const float value = std::clamp(colourAt(image, pixel, c), 0.0F, 1.0F);
      rgb[static_cast<std::size_t>(c)] = image.linear ? value : decodeSrgb(value);
    }
    const Triple opponent = xyzToYcxcz(rgbToXyz(rgb));
    for (std::size_t c = 0; c < 3; ++c) planes[c].values[pixel] = opponent[c];
  }
  return planes;
}

/// L*a*b* with the Hunt effect.
Triple huntLab(const Triple& linearRgb) {
  Triple lab = xyzToLab(rgbToXyz(linearRgb));
  lab[1] *= kHunt * lab[0];
  lab[2] *= kHunt * lab[0];
  return lab;
}

/// Section 4.1.1-4.1.3: what of the colours is seen at this distance, one plane a channel.
std::array<Plane, 3> seenColours(const std::array<Plane, 3>& ycxcz, double ppd) {
  std::array<Plane, 3> seen = {filterSensitivity(ycxcz[0], kAchromatic, ppd),
                               filterSensitivity(ycxcz[1], kRedGreen, ppd),
                               filterSensitivity(ycxcz[2], kBlueYellow, ppd)};
  for (std::size_t pixel = 0; pixel < seen[0].values.size(); ++pixel) {
    const Triple filtered = {seen[0].values[pixel], seen[1].values[pixel], seen[2].values[pixel]};
    Triple rgb = xyzToRgb(ycxczToXyz(filtered));
    for (float& value : rgb) value = std::clamp(value, 0.0F, 1.0F);
    const Triple lab = huntLab(rgb);
    for (std::size_t c = 0; c < 3; ++c) seen[c].values[pixel] = lab[c];
  }
  return seen;
}

/// HyAB distance (Abasi, Amani Tehran & Fairchild 2020): city block in lightness, Euclid in colour.
float hyab(const Triple& a, const Triple& b) {
  const float da = a[1] - b[1];
  const float db = a[2] - b[2];
  return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

/// Section 4.1.4: the colour difference, 0..1.
class ColourError {
 public:
  ColourError() {
    // The largest distance between two colours of sRGB lies between its green and its blue.
    max_ =
        std::pow(hyab(huntLab({0.0F, 1.0F, 0.0F}), huntLab({0.0F, 0.0F, 1.0F})), kColourExponent);
    knee_ = kKneeShare * max_;
  }

  [[nodiscard]] float operator()(const Triple& reference, const Triple& test) const {
    const float error = std::pow(hyab(reference, test), kColourExponent);
    if (error < knee_) return kKneeValue / knee_ * error;
    return kKneeValue + (error - knee_) / (max_ - knee_) * (1.0F - kKneeValue);
  }

 private:
  float max_ = 0.0F;
  float knee_ = 0.0F;
};

/// Scales positive weights to a sum of 1 and negative ones to -1 (section 4.2).
Kernel balanced(const std::vector<double>& kernel) {
  double positive = 0.0;
  double negative = 0.0;
  for (const double weight : kernel) (weight > 0.0 ? positive : negative) += std::abs(weight);
  Kernel result;
  for (const double weight : kernel) {
    result.push_back(static_cast<float>(weight / (weight > 0.0 ? positive : negative)));
  }
  return result;
}

/// Strength of edges and of points (lines, corners) at each pixel.
struct Features {
  Plane edges;
  Plane points;
};

Plane magnitude(const Plane& x, const Plane& y) {
  Plane result(x.width, x.height);
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    result.values[i] = std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
  }
  return result;
}

/// Section 4.2: first and second derivatives of a Gaussian on the unfiltered achromatic channel,
/// brought to 0..1.
Features detectFeatures(const Plane& achromatic, double ppd) {
  const double deviation = 0.5 * kFeatureWidth * ppd;
  const int radius = static_cast<int>(std::ceil(kDeviations * deviation));
  const auto gaussian = [&](double i) { return std::exp(-i * i / (2.0 * deviation * deviation)); };
  const std::vector<double> smooth = sample(radius, gaussian);
  const Kernel along = scaled(smooth, 1.0 / sumOf(smooth));
  const Kernel edge = balanced(sample(radius, [&](double i) { return -i * gaussian(i); }));
  const Kernel point = balanced(sample(
      radius, [&](double i) { return (i * i / (deviation * deviation) - 1.0) * gaussian(i); }));

  Plane luminance(achromatic.width, achromatic.height);
  for (std::size_t i = 0; i < luminance.values.size(); ++i) {
    luminance.values[i] = (achromatic.values[i] + 16.0F) / 116.0F;  // YyCxCz to relative Y
  }
  const Plane smoothRows = filterRows(luminance, along);
  return {magnitude(filterSeparable(luminance, edge, along), filterColumns(smoothRows, edge)),
          magnitude(filterSeparable(luminance, point, along), filterColumns(smoothRows, point))};
}

/// Section 4.2: the larger of the two feature differences, 0..1.
float featureError(const Features& reference, const Features& test, std::size_t pixel) {
  const float edge = std::abs(reference.edges.values[pixel] - test.edges.values[pixel]);
  const float point = std::abs(reference.points.values[pixel] - test.points.values[pixel]);
  const float share = std::max(edge, point) / std::numbers::sqrt2_v<float>;
  return std::clamp(std::pow(share, kFeatureExponent), 0.0F, 1.0F);
}

}  // namespace

Plane flipMap(const ImageF& reference, const ImageF& test, double pixelsPerDegree) {
  if (reference.width != test.width || reference.height != test.height || reference.width < 1 ||
      reference.height < 1) {
    failInput("FLIP needs two images of one size; these are {} x {} and {} x {}", reference.width,
              reference.height, test.width, test.height);
  }
  if (!(pixelsPerDegree >= kMinPixelsPerDegree && pixelsPerDegree <= kMaxPixelsPerDegree)) {
    failInput("FLIP at {} pixels per degree is not defined; give {} to {}", pixelsPerDegree,
              kMinPixelsPerDegree, kMaxPixelsPerDegree);
  }
  const std::array<Plane, 3> referencePlanes = toYcxcz(reference);
  const std::array<Plane, 3> testPlanes = toYcxcz(test);
  const Features referenceFeatures = detectFeatures(referencePlanes[0], pixelsPerDegree);
  const Features testFeatures = detectFeatures(testPlanes[0], pixelsPerDegree);
  const std::array<Plane, 3> a = seenColours(referencePlanes, pixelsPerDegree);
  const std::array<Plane, 3> b = seenColours(testPlanes, pixelsPerDegree);

  const ColourError colourError;
  Plane map(reference.width, reference.height);
  for (std::size_t pixel = 0; pixel < map.values.size(); ++pixel) {
    const float colour = colourError({a[0].values[pixel], a[1].values[pixel], a[2].values[pixel]},
                                     {b[0].values[pixel], b[1].values[pixel], b[2].values[pixel]});
    const float feature = featureError(referenceFeatures, testFeatures, pixel);
    map.values[pixel] = std::pow(colour, 1.0F - feature);  // section 4.3
  }
  return map;
}

double meanOf(const Plane& map) {
  double sum = 0.0;
  for (const float value : map.values) sum += static_cast<double>(value);
  return sum / static_cast<double>(map.values.size());
}

double flipMean(const ImageF& reference, const ImageF& test, double pixelsPerDegree) {
  return meanOf(flipMap(reference, test, pixelsPerDegree));
}

}  // namespace macula::measure
