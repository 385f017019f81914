// Random numbers that are the same on every machine and with every standard library.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace macula::scene {

/// PCG32 (O'Neill 2014, "PCG: A family of simple fast space-efficient statistically good
/// algorithms", XSH-RR variant). Uses integers and one exact scaling, so that a seed gives the same
/// scene everywhere; the distributions of <random> differ between libraries.
class Random {
 public:
  /// @param seed any value; equal seeds give equal sequences
  /// @param stream lets two parts of one scene draw from the same seed without sharing numbers
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0) : increment_((stream << 1U) | 1U) {
    next();
    state_ += seed;
    next();
  }

  /// 32 uniformly distributed bits.
  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * kMultiplier + increment_;
    const auto shifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    const auto turn = static_cast<std::uint32_t>(old >> 59U);
    return (shifted >> turn) | (shifted << ((32U - turn) & 31U));
  }

  /// Uniform in [0, 1), a multiple of 2^-24 (what a float holds exactly).
  float unit() { return static_cast<float>(next() >> 8U) * 0x1p-24F; }

  /// Uniform in [low, high).
  float range(float low, float high) { return low + (high - low) * unit(); }

  /// Uniform in 0 .. count - 1; count >= 1. The bias is below count / 2^32.
  std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(next()) * count) >> 32U);
  }

  /// Uniform in the unit ball, by rejection from its cube.
  glm::vec3 inBall() {
    for (;;) {
      const float x = range(-1.0F, 1.0F);
      const float y = range(-1.0F, 1.0F);
      const float z = range(-1.0F, 1.0F);
      if (x * x + y * y + z * z <= 1.0F) return {x, y, z};
    }
  }

 private:
  static constexpr std::uint64_t kMultiplier = 6364136223846793005ULL;  // O'Neill 2014
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

}  // namespace macula::scene
