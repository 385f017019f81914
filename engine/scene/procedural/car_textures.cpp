// Textures of the car and of the ground.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/scene/procedural/car_parts.h"
#include "engine/scene/procedural/pixels.h"

namespace macula::scene::car {
namespace {

/// Digits and letters of 5 x 7 dots, rows from the top, the highest bit of five on the left.
using Glyph = std::array<std::uint8_t, 7>;
constexpr Glyph kTwo{0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111};
constexpr Glyph kSeven{0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000};
constexpr Glyph kM{0b10001, 0b11011, 0b10101, 0b10101, 0b10001, 0b10001, 0b10001};
constexpr Glyph kC{0b01110, 0b10001, 0b10000, 0b10000, 0b10000, 0b10001, 0b01110};

/// Whether (x, y) in 0..1 of a glyph's box from the top left is ink.
bool isInk(const Glyph& glyph, float x, float y) {
  if (x < 0.0F || x >= 1.0F || y < 0.0F || y >= 1.0F) return false;
  const auto column = static_cast<unsigned>(x * 5.0F);
  const auto row = static_cast<std::size_t>(y * 7.0F);
  return (glyph[row] >> (4U - column) & 1U) != 0;
}

/// Whether (x, y) in metres from the middle, y up, is ink of "27" in figures `height` high.
bool isStartNumber(float x, float y, float height) {
  const float width = 0.62F * height;
  const float gap = 0.14F * height;
  const float row = 0.5F - y / height;
  return isInk(kTwo, (x + width + 0.5F * gap) / width, row) ||
         isInk(kSeven, (x - 0.5F * gap) / width, row);
}

constexpr glm::vec3 kDeep{0.10F, 0.20F, 0.27F};
constexpr glm::vec3 kTeal{0.20F, 0.43F, 0.47F};
constexpr glm::vec3 kPale{0.62F, 0.74F, 0.68F};
constexpr glm::vec3 kSand{0.86F, 0.76F, 0.55F};
constexpr glm::vec3 kOrange{0.93F, 0.42F, 0.10F};
constexpr glm::vec3 kWhite{0.95F, 0.94F, 0.90F};
constexpr glm::vec3 kGap{0.04F, 0.05F, 0.06F};
constexpr float kGapWidth = 0.012F;  // of the gaps around doors and lids, metres

/// Overlapping patches of four tones with sharp borders.
glm::vec3 camouflage(float u, float v, std::uint32_t key) {
  const float large = fractal(u, v, 9, key);
  const float small = fractal(u, v, 14, key + 31);
  if (large > 0.60F) return kSand;
  if (small > 0.60F) return kDeep;
  return large > 0.47F ? kTeal : kPale;
}

/// Whether a point is within half a gap of a line at `at`.
bool onGap(float value, float at) {
  return std::abs(value - at) < 0.5F * kGapWidth;
}

/// Doors, lids and the seams between panels. x in metres, share from sill to ridge.
bool isGap(float x, float share) {
  const bool onFlank = share < kWaistShare + 0.02F;
  if (onFlank && share > 0.02F && (onGap(x, kDoorFront) || onGap(x, kDoorBack))) return true;
  constexpr float kShareGap = 0.004F;  // about as wide, across
  const bool door = x > kDoorBack && x < kDoorFront;
  if (door && std::abs(share - 0.03F) < kShareGap) return true;
  // The bonnet, between its creases, and the boot's lid.
  const bool bonnet = x > 0.90F && x < 1.90F;
  const bool boot = x < -1.64F && x > -2.0F;
  if ((bonnet || boot) && std::abs(share - 0.60F) < kShareGap) return true;
  if (share > 0.60F && (onGap(x, 0.90F) || onGap(x, 1.90F) || onGap(x, -1.64F))) return true;
  return false;
}

}  // namespace

Image livery(int size, std::uint64_t seed) {
  const std::uint32_t key = foldSeed(seed) + 601;
  return drawImage("livery", size, size, [key](float u, float v) {
    const float x = kTail + (kNose - kTail) * u;
    const bool left = v < 0.5F;
    const float share = left ? 2.0F * v : 2.0F - 2.0F * v;
    // The flank is painted in metres: its share of the livery spans the height up to the shoulder.
    const float height = kSill + 0.52F * share / kFlankShare;
    if (isGap(x, share)) return glm::vec4(kGap, 1.0F);
    glm::vec3 color = camouflage(u, v, key);
    // A pair of stripes over the lids and the roof.
    const float fromRidge = (1.0F - share) / (1.0F - kRoofShare);
    if (fromRidge > 0.13F && fromRidge < 0.42F) color = kOrange;
    if (fromRidge > 0.46F && fromRidge < 0.50F) color = kWhite;
    // A stripe along the flank with a chequered border.
    if (height > 0.285F && height < 0.345F) color = kOrange;
    if (height > 0.345F && height < 0.385F) {
      const bool odd = (static_cast<int>((x + 4.0F) * 50.0F) + (height > 0.365F ? 1 : 0)) % 2 == 0;
      color = odd ? kGap : kWhite;
    }
    const float across = left ? -(x - 0.05F) : x - 0.05F;
    const float up = height - 0.545F;
    const float distance = std::sqrt(across * across + up * up);
    if (distance < 0.185F) {
      color = distance > 0.168F || isStartNumber(across, up, 0.19F) ? kGap : kWhite;
    }
    if (share < 0.012F) color = kGap;
    return glm::vec4(color, 1.0F);
  });
}

Image cobbles(int size, std::uint64_t seed) {
  constexpr std::uint32_t kRows = 12;
  constexpr std::uint32_t kInRow = 10;
  const std::uint32_t key = foldSeed(seed) + 701;
  return drawImage("cobbles", size, size, [key](float u, float v) {
    const float y = v * kRows;
    const auto row = static_cast<std::uint32_t>(y);
    const float shift = 0.5F * static_cast<float>(row % 2) + 0.2F * latticeValue(row, 7, key);
    // The joints wave a little, so that no two stones are alike.
    const float wave = 0.30F * (noise(u, v, 24, key + 5) - 0.5F);
    const float x = u * kInRow + shift + wave;
    const auto stone = static_cast<std::uint32_t>(x + 1.0F) % kInRow;
    const float fx = std::min(triangleWave(x), 0.36F) / 0.36F;
    const float fy = std::min(triangleWave(y + 0.8F * wave), 0.40F) / 0.40F;
    const float dome = fx * fy * (2.0F - fx * fy);
    const float tone = latticeValue(stone, row, key + 11);
    const glm::vec3 warm =
        glm::mix(glm::vec3(0.44F, 0.42F, 0.41F), glm::vec3(0.66F, 0.60F, 0.53F), tone) +
        0.16F * (fractal(u, v, 32, key + 3) - 0.5F);
    return glm::vec4(glm::mix(glm::vec3(0.20F, 0.19F, 0.17F), warm, dome), 1.0F);
  });
}

Image bricks(int size, std::uint64_t seed) {
  constexpr std::uint32_t kCourses = 8;
  constexpr std::uint32_t kInCourse = 3;
  const std::uint32_t key = foldSeed(seed) + 809;
  return drawImage("bricks", size, size, [key](float u, float v) {
    const float y = v * kCourses;
    const auto course = static_cast<std::uint32_t>(y);
    const float x = u * kInCourse + 0.5F * static_cast<float>(course % 2);
    const auto brick = static_cast<std::uint32_t>(x) % kInCourse;
    const bool mortar = triangleWave(x) < 0.07F || triangleWave(y) < 0.20F;
    const float grit = fractal(u, v, 32, key);
    const float tone = latticeValue(brick, course, key + 1);
    if (mortar) return glm::vec4(glm::vec3(0.63F, 0.60F, 0.55F) + 0.12F * (grit - 0.5F), 1.0F);
    const glm::vec3 color =
        glm::mix(glm::vec3(0.47F, 0.23F, 0.17F), glm::vec3(0.70F, 0.42F, 0.31F), tone);
    return glm::vec4(color + 0.22F * (grit - 0.5F), 1.0F);
  });
}

Image numberPlate(int width, int height, std::uint64_t seed) {
  const std::uint32_t key = foldSeed(seed) + 907;
  const std::array<const Glyph*, 5> text{&kM, &kC, nullptr, &kTwo, &kSeven};
  return drawImage("plate", width, height, [=](float u, float v) {
    const bool border = std::min({u, 1.0F - u}) < 0.02F || std::min(v, 1.0F - v) < 0.09F;
    const float x = (u - 0.06F) / 0.88F * 5.0F;
    const auto place = static_cast<std::size_t>(std::clamp(x, 0.0F, 4.9F));
    const float inBox = (x - static_cast<float>(place) - 0.1F) / 0.8F;
    const bool ink = text[place] != nullptr && isInk(*text[place], inBox, (v - 0.18F) / 0.64F);
    const float dirt = 0.06F * noise(u, v, 16, key);
    return glm::vec4(border || ink ? kGap : kWhite - dirt, 1.0F);
  });
}

}  // namespace macula::scene::car
