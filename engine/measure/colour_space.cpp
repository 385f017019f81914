#include "engine/measure/colour_space.h"

#include <cmath>
#include <cstddef>

namespace macula::measure {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

/// CIE xy chromaticities of the sRGB primaries and of D65, as IEC 61966-2-1 gives them.
struct Chromaticity {
  double x;
  double y;
};
constexpr std::array<Chromaticity, 3> kPrimaries = {{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}};
constexpr Chromaticity kWhite = {0.3127, 0.3290};

/// XYZ of a chromaticity at luminance 1.
constexpr std::array<double, 3> xyzOf(const Chromaticity& c) {
  return {c.x / c.y, 1.0, (1.0 - c.x - c.y) / c.y};
}

constexpr Matrix inverse(const Matrix& m) {
  const auto minor = [&m](std::size_t row, std::size_t column) {
    const std::size_t r0 = (row + 1) % 3;
    const std::size_t r1 = (row + 2) % 3;
    const std::size_t c0 = (column + 1) % 3;
    const std::size_t c1 = (column + 2) % 3;
    return m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0];  // cyclic, so the sign is in it
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      result[row][column] = minor(column, row) / determinant;
    }
  }
  return result;
}

/// The primaries' XYZ as columns, each scaled so that R = G = B = 1 is white (SMPTE RP 177).
constexpr Matrix rgbToXyzMatrix() {
  Matrix columns{};
  for (std::size_t primary = 0; primary < 3; ++primary) {
    const auto xyz = xyzOf(kPrimaries[primary]);
    for (std::size_t row = 0; row < 3; ++row) columns[row][primary] = xyz[row];
  }
  const Matrix toScale = inverse(columns);
  const auto white = xyzOf(kWhite);
  for (std::size_t primary = 0; primary < 3; ++primary) {
    double scale = 0.0;
    for (std::size_t i = 0; i < 3; ++i) scale += toScale[primary][i] * white[i];
    for (std::size_t row = 0; row < 3; ++row) columns[row][primary] *= scale;
  }
  return columns;
}

using MatrixF = std::array<std::array<float, 3>, 3>;

constexpr MatrixF narrow(const Matrix& m) {
  MatrixF result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      result[row][column] = static_cast<float>(m[row][column]);
    }
  }
  return result;
}

constexpr MatrixF kRgbToXyz = narrow(rgbToXyzMatrix());
constexpr MatrixF kXyzToRgb = narrow(inverse(rgbToXyzMatrix()));
constexpr Triple kWhiteXyz = {static_cast<float>(xyzOf(kWhite)[0]), 1.0F,
                              static_cast<float>(xyzOf(kWhite)[2])};

Triple multiply(const MatrixF& m, const Triple& v) {
  Triple result{};
  for (std::size_t row = 0; row < 3; ++row) {
    result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
  }
  return result;
}

// CIE 15:2004: L* = 116 f(Y) - 16, a* = 500 (f(X) - f(Y)), b* = 200 (f(Y) - f(Z)), each relative to
// white; f is a cube root with a straight part below (6/29)^3. YyCxCz has f(t) = t.
constexpr float kLightness = 116.0F;
constexpr float kLightnessOffset = 16.0F;
constexpr float kRedGreen = 500.0F;
constexpr float kBlueYellow = 200.0F;
constexpr float kKnee = 6.0F / 29.0F;

float cubeRootOrLine(float t) {
  if (t > kKnee * kKnee * kKnee) return std::cbrt(t);
  return t / (3.0F * kKnee * kKnee) + 4.0F / 29.0F;
}

Triple opponents(float x, float y, float z) {
  return {kLightness * y - kLightnessOffset, kRedGreen * (x - y), kBlueYellow * (y - z)};
}

}  // namespace

Triple rgbToXyz(const Triple& rgb) {
  return multiply(kRgbToXyz, rgb);
}

Triple xyzToRgb(const Triple& xyz) {
  return multiply(kXyzToRgb, xyz);
}

Triple xyzToLab(const Triple& xyz) {
  return opponents(cubeRootOrLine(xyz[0] / kWhiteXyz[0]), cubeRootOrLine(xyz[1] / kWhiteXyz[1]),
                   cubeRootOrLine(xyz[2] / kWhiteXyz[2]));
}

Triple xyzToYcxcz(const Triple& xyz) {
  return opponents(xyz[0] / kWhiteXyz[0], xyz[1] / kWhiteXyz[1], xyz[2] / kWhiteXyz[2]);
}

Triple ycxczToXyz(const Triple& ycxcz) {
  const float y = (ycxcz[0] + kLightnessOffset) / kLightness;
  const float x = y + ycxcz[1] / kRedGreen;
  const float z = y - ycxcz[2] / kBlueYellow;
  return {x * kWhiteXyz[0], y * kWhiteXyz[1], z * kWhiteXyz[2]};
}

}  // namespace macula::measure
