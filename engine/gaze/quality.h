// How good a recording is, in the numbers that `macula gaze info` prints.
#pragma once

#include <cstddef>

#include "engine/gaze/log.h"

namespace macula::gaze {

/// Quality of a whole log. Times are measured over samples whose time goes forward.
struct GazeQuality {
  std::size_t samples = 0;
  std::size_t lost = 0;          ///< samples without one valid eye
  double rateHz = 0.0;           ///< 1 / median interval; 0 where there are fewer than two times
  double durationSeconds = 0.0;  ///< from the first sample to the newest
  /// Longest time without a valid sample, from when the first missing one was due until the next
  /// valid one: n lost samples in a row last n intervals. Lost samples and silence count alike.
  double longestDropoutSeconds = 0.0;
  /// Valid samples outside the window, 0 <= x < 1 and 0 <= y < 1: pixel w of a screen that is w
  /// pixels wide lies off it.
  std::size_t offScreen = 0;
};

[[nodiscard]] GazeQuality assess(const GazeLog& log);

/// Median time between samples that follow each other forward in time, in seconds; 0 where there
/// are fewer than two.
[[nodiscard]] double medianInterval(const GazeLog& log);

}  // namespace macula::gaze
