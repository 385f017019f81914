// Sine and cosine by exact arithmetic alone, so that recipes give the same bits on every machine;
// the last bit of libm's depends on its version and on the processor.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace macula::scene {

/// (cosine, sine) of an angle in turns (1 = 360 degrees). Taylor series after reduction to an
/// eighth of a turn; the error is below the rounding to float.
[[nodiscard]] inline glm::vec2 onCircle(double turns) {
  constexpr double kQuarterTurn = 1.5707963267948966;
  const double quarters = (turns - std::floor(turns)) * 4.0;
  const int nearest = static_cast<int>(quarters + 0.5);
  const double x = (quarters - nearest) * kQuarterTurn;
  const double x2 = x * x;
  double cosine = 1.0;
  double sine = 1.0;
  for (int k = 14; k > 0; k -= 2) {  // Horner; x^16 / 16! is below 1e-15 here
    cosine = 1.0 - cosine * x2 / (k * (k - 1));
    sine = 1.0 - sine * x2 / (k * (k + 1));
  }
  sine *= x;
  switch (nearest & 3) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

}  // namespace macula::scene
