// How good a recording is, in the numbers that `macula gaze info` prints.
#pragma once

#include <cstddef>

#include "engine/gaze/eye_movements.h"
#include "engine/gaze/interval_histogram.h"
#include "engine/gaze/log.h"

namespace macula::gaze {

/// Quality of a whole log. Times are measured over samples whose time goes forward.
struct GazeQuality {
  std::size_t samples = 0;
  std::size_t lost = 0;  ///< samples without one valid eye
  /// 1 / median interval, or, where the clock is too coarse for that (16 and 17 ms for 60 Hz), over
  /// the mean of the intervals within half of the median; 0 where there are fewer than two times.
  double rateHz = 0.0;
  double durationSeconds = 0.0;  ///< from the first sample to the newest
  /// Longest time without a valid sample, from when the first missing one was due until the next
  /// valid one: n lost samples in a row last n intervals. Lost samples and silence count alike.
  double longestDropoutSeconds = 0.0;
  /// Valid samples outside the window, 0 <= x < 1 and 0 <= y < 1: pixel w of a screen that is w
  /// pixels wide lies off it.
  std::size_t offScreen = 0;
  /// Standard deviation of the intervals up to two medians; longer ones are losses.
  double jitterSeconds = 0.0;
  /// Times that the same place, bit for bit, came for kFrozenSeconds and kFrozenSamples, valid or
  /// not: the tracker repeated itself.
  std::size_t frozenRuns = 0;
  EyeMovements movements;
};

/// Finds what a clock counts in: the longest of 10, 1, 0.1, 0.01, 0.001 ms of which every step is a
/// whole multiple.
class ClockTick {
 public:
  /// @param step between two times, in seconds
  void note(double step);
  /// 0 where the clock is finer than a microsecond.
  [[nodiscard]] double seconds() const { return tick_; }

 private:
  double tick_ = 0.01;
};

/// What turns places into angles and angles into movements.
struct QualityOptions {
  double ivtThreshold = kIvtThreshold;  ///< degrees a second
  Display display = {};
};

/// Registers `gaze.ivtThreshold`; `options` must outlive the registry. `display.*` are registered
/// by registerSettings(registry, options.display).
void registerSettings(settings::Registry& registry, QualityOptions& options);

/// Measures a log sample by sample, in memory that does not grow with it. The rate is within the
/// bounds that IntervalHistogram states.
class QualityMeter {
 public:
  explicit QualityMeter(const QualityOptions& options = {});
  /// Samples in the order of the file.
  void add(const GazeSample& sample);
  /// Of all samples so far.
  [[nodiscard]] GazeQuality quality() const;

 private:
  void countFrozen(const GazeSample& sample);
  [[nodiscard]] double interval() const;

  GazeQuality counts_;
  IntervalHistogram intervals_;
  ClockTick tick_;
  std::size_t repeatedTimes_ = 0;
  EyeMovementClassifier movements_;
  double first_ = 0.0;  ///< times
  double newest_ = 0.0;
  double lastValid_ = 0.0;
  bool anyValid_ = false;
  double headDropout_ = 0.0;   ///< before the first valid sample
  double innerDropout_ = 0.0;  ///< longest step between valid samples
  glm::dvec2 frozenPlace_ = kNoPosition;
  double frozenSince_ = 0.0;
  std::size_t frozenSamples_ = 0;
  bool frozenCounted_ = false;
};

[[nodiscard]] GazeQuality assess(const GazeLog& log, const QualityOptions& options = {});

/// Median time between samples that follow each other forward in time, in seconds; 0 where there
/// are fewer than two. Exact.
[[nodiscard]] double medianInterval(const GazeLog& log);

}  // namespace macula::gaze
