// Random numbers that are the same on every machine and with every standard library.
#pragma once

#include <bit>
#include <cstdint>

namespace macula {

/// PCG32 (O'Neill 2014, "PCG: A family of simple fast space-efficient statistically good
/// algorithms", XSH-RR variant). Uses integers and exact scalings, so that a seed gives the same
/// numbers everywhere; the distributions of <random> differ between libraries.
class Random {
 public:
  /// @param seed any value; equal seeds give equal sequences
  /// @param stream lets two parts of one whole draw from the same seed without sharing numbers
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0) : increment_((stream << 1U) | 1U) {
    next();
    state_ += seed;
    next();
  }

  /// 32 uniformly distributed bits.
  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * kMultiplier + increment_;
    const auto mixed = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    return std::rotr(mixed, static_cast<int>(old >> 59U));
  }

  /// Uniform in [0, 1), a multiple of 2^-24 (what a float holds exactly).
  float unit() { return static_cast<float>(next() >> 8U) * 0x1p-24F; }

  /// Uniform in [low, high), by unit().
  float range(float low, float high) { return low + (high - low) * unit(); }

  /// Uniform in 0 .. count - 1; count >= 1. The bias is below count / 2^32.
  std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(next()) * count) >> 32U);
  }

  /// Uniform in [0, 1), a multiple of 2^-32.
  double uniform() { return static_cast<double>(next()) * 0x1p-32; }

  /// Uniform in [low, high), by uniform().
  double between(double low, double high) { return low + (high - low) * uniform(); }

  /// Mean 0, variance 1, nearly Gaussian: the sum of twelve uniform numbers (Irwin-Hall). No
  /// logarithm, whose last bit differs between machines.
  double gauss() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

 private:
  static constexpr std::uint64_t kMultiplier = 6364136223846793005ULL;  // O'Neill 2014
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

}  // namespace macula
