#include "engine/gaze/saccade_detector.h"

namespace macula::gaze {

void SaccadeDetector::observe(double timeSeconds, const glm::dvec2& degrees) {
  const double seconds = timeSeconds - time_;
  const bool neighbours = started_ && seconds > 0.0 && seconds <= kLongestGapSeconds;
  speed_ = neighbours ? glm::length(degrees - degrees_) / seconds : 0.0;
  if (inSaccade_) {
    inSaccade_ = speed_ >= kOffsetShare * settings_.onsetSpeed &&
                 timeSeconds - onset_ <= kLongestSaccadeSeconds;
  } else if (speed_ >= settings_.onsetSpeed) {
    inSaccade_ = true;
    onset_ = time_;
  }
  started_ = true;
  time_ = timeSeconds;
  degrees_ = degrees;
}

}  // namespace macula::gaze
