// Saccades in a stream of gaze, as it comes.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

namespace macula::gaze {

struct SaccadeSettings {
  /// Degrees a second at which a saccade begins. Noise of 0.3 degrees at 90 Hz stays below 40;
  /// a saccade of 5 degrees reaches 200 (Bahill 1975, main sequence).
  double onsetSpeed = 100.0;
};

/// Velocity threshold with hysteresis, on gaze in degrees of visual angle. The speed is taken over
/// 8 ms or one interval, whichever is longer: between the samples of a fast tracker, noise alone is
/// as fast as a saccade. Causal: it knows a saccade one such step after the eye has started.
class SaccadeDetector {
 public:
  /// Noise of 0.2 degrees then stays below 50 degrees a second at any rate.
  static constexpr double kBaselineSeconds = 0.008;
  /// A saccade ends below this share of the onset speed.
  static constexpr double kOffsetShare = 0.5;
  /// Over a longer gap no speed is taken: what lies between is unknown. (I-VT fills gaps up to it.)
  static constexpr double kLongestGapSeconds = 0.075;
  /// No saccade is longer: 100 degrees take about 250 ms (Carpenter 1988). What goes on is a
  /// tracker that drifts, and must not hold the filter off for ever.
  static constexpr double kLongestSaccadeSeconds = 0.250;

  explicit SaccadeDetector(const SaccadeSettings& settings = {}) : settings_(settings) {}

  /// Takes the next believed sample; times increase.
  void observe(double timeSeconds, const glm::dvec2& degrees);
  /// The next sample has no neighbour: nothing was believed in between.
  void reset();

  [[nodiscard]] bool inSaccade() const { return inSaccade_; }
  /// Degrees a second at the newest sample; 0 where it has no neighbour.
  [[nodiscard]] double speed() const { return speed_; }

 private:
  /// Samples within the baseline, at up to 4 kHz.
  static constexpr std::size_t kMostSamples = 32;
  struct Sample {
    double time = 0.0;
    glm::dvec2 degrees{0.0};
  };

  [[nodiscard]] double speedAt(const Sample& sample);

  SaccadeSettings settings_;
  std::array<Sample, kMostSamples> samples_{};  ///< the newest count_, oldest first
  std::size_t count_ = 0;
  bool inSaccade_ = false;
  double onset_ = 0.0;
  double speed_ = 0.0;
};

}  // namespace macula::gaze
