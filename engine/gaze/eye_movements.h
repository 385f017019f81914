// Fixations and saccades by a velocity threshold, one sample at a time.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>

#include "engine/gaze/display.h"

namespace macula::gaze {

/// Speed from which on the eye is in a saccade, in degrees a second (I-VT; Olsen 2012).
inline constexpr double kIvtThreshold = 30.0;
/// A speed is that over this long a time (or one step, where steps are longer), since the noise of
/// neighbouring samples at 1 kHz alone passes the threshold (Olsen 2012, velocity calculator).
inline constexpr double kIvtWindowSeconds = 0.020;
/// Fixations this close in time and angle are one, and a loss up to this long parts none (Olsen
/// 2012, gap fill-in and merging).
inline constexpr double kIvtMergeSeconds = 0.075;
inline constexpr double kIvtMergeDegrees = 0.5;
/// Shorter fixations are none (Olsen 2012).
inline constexpr double kIvtShortestFixation = 0.060;

/// What the eye did in a recording.
struct EyeMovements {
  std::size_t fixations = 0;
  double fixationSeconds = 0.0;  ///< mean duration; 0 where there are none
  std::size_t saccades = 0;
  double saccadeDegrees = 0.0;  ///< mean amplitude; 0 where there are none
};

/// Sorts the steps between samples into fixations and saccades. No speed is ever taken across a
/// lost sample or a step of more than kIvtMergeSeconds.
class EyeMovementClassifier {
 public:
  /// @param threshold degrees a second, > 0
  EyeMovementClassifier(double threshold, const Display& display);

  /// @param timeSeconds later than that of the sample before
  /// @param place 0..1 of the display; nothing where the eye was lost
  void add(double timeSeconds, const std::optional<glm::dvec2>& place);

  /// Of all samples so far.
  [[nodiscard]] EyeMovements result() const;

 private:
  struct Point {
    double time = 0.0;
    glm::dvec2 place{0.0};
  };
  enum class Kind { None, Fixation, Saccade };
  struct Movement {
    Kind kind = Kind::None;
    Point begin;
    Point end;
  };
  /// Movements that are over, and the last fixation, which may still be joined by the next.
  struct Tally {
    std::size_t fixations = 0;
    double fixationSeconds = 0.0;
    std::size_t saccades = 0;
    double saccadeDegrees = 0.0;
    std::optional<Movement> pending;
    std::size_t pendingSaccades = 0;  ///< after the pending fixation: gone when it is joined
    double pendingDegrees = 0.0;
  };

  void close(Tally& tally, const Movement& movement) const;
  void settle(Tally& tally) const;
  [[nodiscard]] double speedTo(const Point& point);

  double threshold_;
  Display display_;
  /// The unbroken run of samples within the window; the newest is at (next_ - 1).
  std::array<Point, 64> recent_;
  std::size_t next_ = 0;
  std::size_t held_ = 0;
  Movement current_;
  Tally tally_;
};

}  // namespace macula::gaze
