#include "engine/gaze/delay.h"

namespace macula::gaze {

GazeDelay::GazeDelay() : ring_(kCapacity) {}

PointOfInterest GazeDelay::next(double timeSeconds, const PointOfInterest& point,
                                double latencySeconds) {
  const auto entry = [&](std::size_t i) -> Entry& { return ring_[(oldest_ + i) % kCapacity]; };
  const auto dropOldest = [&] {
    oldest_ = (oldest_ + 1) % kCapacity;
    --count_;
  };
  if (count_ == kCapacity) dropOldest();
  entry(count_++) = {timeSeconds, point};
  // The second oldest is known already: the oldest is of no more use.
  while (count_ > 1 && entry(1).time <= timeSeconds - latencySeconds) dropOldest();
  PointOfInterest delayed = entry(0).point;
  delayed.ageSeconds += static_cast<float>(timeSeconds - entry(0).time);
  return delayed;
}

}  // namespace macula::gaze
