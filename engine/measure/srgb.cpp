#include "engine/measure/srgb.h"

#include <cmath>

namespace macula::measure {
namespace {

// IEC 61966-2-1, the encoding and its decoding: a straight part near black, then a power.
constexpr float kSlope = 12.92F;
constexpr float kLinearKnee = 0.0031308F;
constexpr float kEncodedKnee = 0.04045F;
constexpr float kOffset = 0.055F;
constexpr float kGamma = 2.4F;

}  // namespace

float encodeSrgb(float linear) {
  if (linear <= kLinearKnee) return linear * kSlope;
  return (1.0F + kOffset) * std::pow(linear, 1.0F / kGamma) - kOffset;
}

float decodeSrgb(float encoded) {
  if (encoded <= kEncodedKnee) return encoded / kSlope;
  return std::pow((encoded + kOffset) / (1.0F + kOffset), kGamma);
}

}  // namespace macula::measure
