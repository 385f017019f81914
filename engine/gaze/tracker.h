// The loss rule: from samples as a tracker gives them to a point of interest that never jumps
// because an eye was lost. Causal and without a clock of its own.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <limits>

#include "engine/gaze/fovea.h"
#include "engine/gaze/log.h"
#include "engine/gaze/point_of_interest.h"
#include "engine/gaze/refiner.h"

namespace macula::gaze {

/// After the last trusted sample the point stays for this long: most blinks end within it.
inline constexpr double kHoldSeconds = 0.200;
/// After a loss, samples are not believed for this long: around a blink they deviate by hundreds of
/// pixels although the tracker calls them valid.
inline constexpr double kDistrustSeconds = 0.100;
/// The same place, bit for bit, for this long and in at least kFrozenSamples samples is a tracker
/// that repeats itself: no eye is that still, and a fixation is noisier than a pixel.
inline constexpr double kFrozenSeconds = 0.100;
inline constexpr std::size_t kFrozenSamples = 3;
/// No sample for this many intervals, and at least for kSilenceSeconds, is a loss. One missing
/// sample is jitter; drivers that drop the samples of a blink are silent for 100 ms and more.
inline constexpr double kSilenceIntervals = 3.0;
inline constexpr double kSilenceSeconds = 0.060;

/// The point's speed while it eases, in windows a second: constant when far, then falling with the
/// square root of the distance (constant deceleration), and constant again near the goal, so that
/// it arrives on a goal that trembles as a fixation does.
inline constexpr double kFastestEase = 2.0;        ///< 3.3 % of the window a frame at 60 Hz
inline constexpr double kSlowestEase = 0.5;        ///< faster than the noise of a fixation wanders
inline constexpr double kEaseDeceleration = 10.0;  ///< windows/s^2: brakes over the last fifth

/// Places with a larger coordinate are codes (INT32_MAX, -32768 px), not gaze.
inline constexpr double kFarthestPlace = 100.0;

/// Times closer than this are equal: trackers count microseconds.
inline constexpr double kTimeTolerance = 1e-6;

/// A point on the straight way from `point` to `goal`, `seconds` later, under the ease speeds.
/// Lengths are in windows; the result does not depend on how `seconds` is cut into steps.
[[nodiscard]] glm::dvec2 easeTowards(const glm::dvec2& point, const glm::dvec2& goal,
                                     double seconds);

/// What a stream of samples is taken for.
struct TrackerOptions {
  double sampleInterval = 0.0;  ///< nominal, in seconds, for the silence rule; 0 where unknown
  double latencySeconds = 0.0;  ///< >= 0; by how much later than its time a sample is known
  bool live = false;            ///< from a device now, not from a log
  PipelineSettings pipeline = {};
  Display display = {};
};

/// Follows one stream of samples from a tracker. Feed samples and ask for the point in the order of
/// their times.
class PointOfInterestTracker {
 public:
  explicit PointOfInterestTracker(const TrackerOptions& options = {});

  /// Of a live tracker, whose rate shows only as it runs. @param seconds >= 0
  void setSampleInterval(double seconds);
  /// What the window's shares are of, for angles.
  void setDisplay(const Display& display) { refiner_.setDisplay(display); }

  /// Takes the next sample. One that is not later than the newest so far is ignored.
  void observe(const GazeSample& sample);

  /// The source has nothing more to say from `time` on (end of a log, device gone).
  void lose(double time);

  /// The point of interest at a time, by the clock of the samples; a time before the newest one
  /// seen counts as that one.
  [[nodiscard]] PointOfInterest at(double time);

 private:
  enum class Trust { NeverSeen, Trusted, Lost, Distrusted };

  void noticeSilence(double time);
  void advance(double time);
  bool extendsFrozenRun(const GazeSample& sample);
  void trust(const GazeSample& sample);
  [[nodiscard]] double holdEnd() const;
  [[nodiscard]] GazeState state() const;

  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  double silenceLimit_;
  double latency_;
  bool widens_;
  glm::dvec2 offset_;
  GazeRefiner refiner_;
  FoveaRadius fovea_;
  bool saccadeSeen_ = false;  ///< since the point was last asked for
  double now_ = kNever;
  double newestTime_ = kNever;
  glm::dvec2 raw_ = kNoPosition;

  Trust trust_ = Trust::NeverSeen;
  glm::dvec2 position_{0.5};
  glm::dvec2 gaze_{0.5};     ///< newest trusted place, refined and clamped to the window
  bool catchingUp_ = false;  ///< trusted, but the point is still on its way to gaze_
  double trustedAt_ = kNever;
  double lostAt_ = kNever;
  double returnedAt_ = kNever;
  bool heldAtReturn_ = false;

  glm::dvec2 runPlace_ = kNoPosition;  ///< the place that the newest samples repeat
  double runStart_ = kNever;
  std::size_t runLength_ = 0;
  double trustedAtRunStart_ = kNever;  ///< trustedAt_ after the run's first sample
};

}  // namespace macula::gaze
