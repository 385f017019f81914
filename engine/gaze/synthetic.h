// A synthetic gaze log that behaves like a real one, for demos and tests. Never a stand-in for
// people.
#pragma once

#include <cstdint>

#include "engine/gaze/log.h"

namespace macula::gaze {

struct SyntheticGazeOptions {
  std::uint64_t seed = 1;
  double durationSeconds = 20.0;  ///< 0.1 to 86,400
  double rateHz = 120.0;          ///< 1 to 10,000
  double blinksPerMinute = 14.0;  ///< 0 to 30; adults at a screen: 10 to 20
  int dropouts = 2;               ///< 0 to 100; flagged and silent ones in turn
};

/// Fixations with drift and jitter, saccades on the main sequence, blinks with the wrong places
/// that trackers report around them, dropouts, and glances off the screen. The same options give
/// the same bits on every machine. Times are whole microseconds, places multiples of 1e-5.
/// @throws InputError where an option is outside its range
[[nodiscard]] GazeLog synthesizeGaze(const SyntheticGazeOptions& options);

}  // namespace macula::gaze
