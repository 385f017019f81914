#include "engine/gaze/fovea.h"

#include <algorithm>

#include "engine/gaze/point_of_interest.h"

namespace macula::gaze {

float FoveaRadius::at(double timeSeconds, double ageSeconds, bool inSaccade) {
  const double unknown = std::max(ageSeconds - interval_, 0.0);
  const double wanted = std::min(kGazeSpeed * unknown + (inSaccade ? kInSaccade : 0.0), kWidest);
  if (!started_) {
    extra_ = wanted;
    started_ = true;
  } else {
    const double seconds = std::max(timeSeconds - time_, 0.0);
    extra_ = std::clamp(wanted, extra_ - kShrinkage * seconds, extra_ + kGrowth * seconds);
  }
  time_ = timeSeconds;
  return kFoveaRadius + static_cast<float>(extra_);
}

}  // namespace macula::gaze
