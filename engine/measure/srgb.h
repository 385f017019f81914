// The sRGB transfer curve, IEC 61966-2-1.
#pragma once

namespace macula::measure {

/// Linear to encoded, both 0..1. Values outside are not clamped: below 0 the curve's straight part
/// goes on, above 1 its power. NaN stays NaN.
[[nodiscard]] float encodeSrgb(float linear);

/// The inverse of encodeSrgb().
[[nodiscard]] float decodeSrgb(float encoded);

}  // namespace macula::measure
