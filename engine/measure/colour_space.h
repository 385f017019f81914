// The colour spaces of FLIP, on float triples. Linear RGB has the primaries of sRGB; white is D65.
#pragma once

#include <array>

namespace macula::measure {

using Triple = std::array<float, 3>;

/// Linear RGB to CIE 1931 XYZ, and back.
[[nodiscard]] Triple rgbToXyz(const Triple& rgb);
[[nodiscard]] Triple xyzToRgb(const Triple& xyz);

/// XYZ to CIE 1976 L*a*b*.
[[nodiscard]] Triple xyzToLab(const Triple& xyz);

/// XYZ to YyCxCz, an opponent space like L*a*b* without its cube root (Flohr, Kolpatzik,
/// Balasubramanian, Carrara, Bouman & Allebach 1993), and back.
[[nodiscard]] Triple xyzToYcxcz(const Triple& xyz);
[[nodiscard]] Triple ycxczToXyz(const Triple& ycxcz);

}  // namespace macula::measure
