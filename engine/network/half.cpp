#include "engine/network/half.h"

#include <cmath>
#include <limits>

namespace macula::network {

float floatOfHalf(std::uint16_t half) {
  // 1 bit of sign, 5 of exponent with bias 15, 10 of fraction.
  const bool negative = (half & 0x8000U) != 0;
  const int exponent = (half >> 10U) & 0x1F;
  const int fraction = half & 0x3FF;
  float magnitude = 0.0F;
  if (exponent == 0x1F) {
    magnitude = fraction == 0 ? std::numeric_limits<float>::infinity()
                              : std::numeric_limits<float>::quiet_NaN();
  } else if (exponent == 0) {  // no hidden bit; the least step is 2^(1 - 15 - 10)
    magnitude = std::ldexp(static_cast<float>(fraction), -24);
  } else {
    magnitude = std::ldexp(static_cast<float>(fraction + 0x400), exponent - 15 - 10);
  }
  return negative ? -magnitude : magnitude;
}

}  // namespace macula::network
