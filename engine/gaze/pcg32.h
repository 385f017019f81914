// PCG-XSH-RR 64/32: O'Neill 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good
// Algorithms for Random Number Generation". The same numbers on every machine, unlike the
// distributions of the standard library.
#pragma once

#include <bit>
#include <cstdint>

namespace macula::gaze {

class Pcg32 {
 public:
  /// @param stream different streams of one seed are independent
  explicit Pcg32(std::uint64_t seed, std::uint64_t stream = 0) : increment_((stream << 1U) | 1U) {
    advance();
    state_ += seed;
    advance();
  }

  [[nodiscard]] std::uint32_t next() {
    const std::uint64_t old = state_;
    advance();
    const auto mixed = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    return std::rotr(mixed, static_cast<int>(old >> 59U));
  }

  /// Uniform in 0 <= u < 1, a multiple of 2^-32.
  [[nodiscard]] double uniform() { return static_cast<double>(next()) * 0x1p-32; }

  /// Uniform in a range.
  [[nodiscard]] double between(double low, double high) { return low + (high - low) * uniform(); }

  /// Mean 0, variance 1, nearly Gaussian: the sum of twelve uniform numbers (Irwin-Hall). No
  /// logarithm, whose last bit differs between machines.
  [[nodiscard]] double gauss() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

 private:
  void advance() { state_ = state_ * kMultiplier + increment_; }

  static constexpr std::uint64_t kMultiplier = 6364136223846793005ULL;  // of the reference
  std::uint64_t increment_;                                             // odd
  std::uint64_t state_ = 0;
};

}  // namespace macula::gaze
