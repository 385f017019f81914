#include "engine/measure/srgb.h"

#include <cmath>

namespace macula::measure {
namespace {

// IEC 61966-2-1, the encoding and its decoding: a straight part near black, then a power. In
// double, so that 1 stays exactly 1 both ways.
constexpr double kSlope = 12.92;
constexpr double kLinearKnee = 0.0031308;
constexpr double kEncodedKnee = 0.04045;
constexpr double kOffset = 0.055;
constexpr double kGamma = 2.4;

}  // namespace

float encodeSrgb(float linear) {
  const double x = linear;
  const double encoded =
      x <= kLinearKnee ? x * kSlope : (1.0 + kOffset) * std::pow(x, 1.0 / kGamma) - kOffset;
  return static_cast<float>(encoded);
}

float decodeSrgb(float encoded) {
  const double x = encoded;
  const double linear =
      x <= kEncodedKnee ? x / kSlope : std::pow((x + kOffset) / (1.0 + kOffset), kGamma);
  return static_cast<float>(linear);
}

}  // namespace macula::measure
