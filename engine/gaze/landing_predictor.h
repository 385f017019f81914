// Where a saccade that is under way will land.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

namespace macula::gaze {

/// Fits the course of a saccade to the samples since shortly before its onset. The eye goes
/// straight, and covers A s((t - t0) / D) of an amplitude A with the minimum-jerk course
/// s(u) = 10 u^3 - 15 u^4 + 6 u^5 (Flash and Hogan 1985), in a duration D = 2.2 ms A + 21 ms
/// (Carpenter 1988). A and t0 are searched for on a grid, by least squares over the way covered
/// under a tracker's noise, with common amplitudes preferred while the samples leave it open.
class LandingPredictor {
 public:
  /// A sample outside of a saccade. Times increase.
  void rest(double timeSeconds, const glm::dvec2& degrees);
  /// A sample of a saccade. @returns the place where it will land, in degrees
  [[nodiscard]] glm::dvec2 moving(double timeSeconds, const glm::dvec2& degrees);
  /// Gaze was lost: nothing from before counts.
  void reset() { count_ = 0; }

 private:
  /// More improve nothing. Closer samples than kLeastStep are left out, so that they span 128 ms:
  /// a saccade of 48 degrees.
  static constexpr std::size_t kMostSamples = 64;
  static constexpr double kLeastStep = 0.002;
  /// A saccade is noticed once it is fast; this long before, the eye was at rest.
  static constexpr double kNoticedLate = 0.020;

  struct Sample {
    double time = 0.0;
    glm::dvec2 degrees{0.0};
  };

  void keep(double timeSeconds, const glm::dvec2& degrees);
  /// Drops the samples before the one that lies kNoticedLate back.
  void forgetBefore(double timeSeconds);

  std::array<Sample, kMostSamples> samples_{};
  std::size_t count_ = 0;
  bool moving_ = false;
};

}  // namespace macula::gaze
