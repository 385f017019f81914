// Saccades in a stream of gaze, as it comes.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>

namespace macula::gaze {

struct SaccadeSettings {
  /// Degrees a second at which a saccade begins. Noise of 0.3 degrees at 90 Hz stays below 40;
  /// a saccade of 5 degrees reaches 200 (Bahill 1975, main sequence).
  double onsetSpeed = 100.0;
};

/// Velocity threshold with hysteresis, on gaze in degrees of visual angle. Causal: it knows a
/// saccade from the sample after the eye has started.
class SaccadeDetector {
 public:
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
  void reset() { started_ = inSaccade_ = false; }

  [[nodiscard]] bool inSaccade() const { return inSaccade_; }
  /// Degrees a second between the two newest samples; 0 after a gap.
  [[nodiscard]] double speed() const { return speed_; }

 private:
  SaccadeSettings settings_;
  bool started_ = false;
  bool inSaccade_ = false;
  double time_ = 0.0;
  double onset_ = 0.0;
  double speed_ = 0.0;
  glm::dvec2 degrees_{0.0};
};

}  // namespace macula::gaze
