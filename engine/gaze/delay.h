// Latency for a source that knows no other: the mouse, or a tracker that is quicker than wanted.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/gaze/point_of_interest.h"

namespace macula::gaze {

/// Gives points of interest back later than they came.
class GazeDelay {
 public:
  /// Points that are kept: 10 s at 400 frames a second. More frames a second shorten the delay.
  static constexpr std::size_t kCapacity = 4096;

  GazeDelay();

  /// Takes the point of a frame and gives the one that was known `latencySeconds` before, with that
  /// much more age; the oldest one until there is such a point.
  /// @param timeSeconds does not decrease
  [[nodiscard]] PointOfInterest next(double timeSeconds, const PointOfInterest& point,
                                     double latencySeconds);

 private:
  struct Entry {
    double time = 0.0;
    PointOfInterest point;
  };
  std::vector<Entry> ring_;
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
};

}  // namespace macula::gaze
