// How far around the point of interest the eye may be.
#pragma once

namespace macula::gaze {

/// The fovea's radius for an uncertain gaze: kFoveaRadius, plus what the eye may have gone since it
/// was last known, more in a saccade. Lengths are shares of the window's height. It grows and
/// shrinks at limited speeds, so that a blink makes no step in the picture.
class FoveaRadius {
 public:
  /// Of the eye over several fixations (three saccades of 4 degrees a second, on a window that
  /// spans 25 degrees): what an age is worth.
  static constexpr double kGazeSpeed = 0.5;
  /// Where nothing has been known for long.
  static constexpr double kWidest = 0.3;
  /// Half of a common saccade (15 degrees at most in pictures; Bahill 1975).
  static constexpr double kInSaccade = 0.15;
  static constexpr double kGrowth = 2.0;  ///< a second: at once for the eye, in 4 frames for 0.15
  static constexpr double kShrinkage = 0.5;  ///< a second

  /// @param sampleInterval age that even the newest sample has, in seconds
  explicit FoveaRadius(double sampleInterval) : interval_(sampleInterval) {}

  void setSampleInterval(double seconds) { interval_ = seconds; }

  /// The radius at a time; times do not decrease.
  /// @param ageSeconds since the last believed sample was taken; may be infinite
  [[nodiscard]] float at(double timeSeconds, double ageSeconds, bool inSaccade);

 private:
  double interval_;
  double time_ = 0.0;
  double extra_ = 0.0;
  bool started_ = false;
};

}  // namespace macula::gaze
