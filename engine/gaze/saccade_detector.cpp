#include "engine/gaze/saccade_detector.h"

#include <algorithm>

namespace macula::gaze {

void SaccadeDetector::reset() {
  count_ = 0;
  inSaccade_ = false;
  speed_ = 0.0;
}

/// Speed from the newest kept sample that lies a baseline back; drops those before it.
double SaccadeDetector::speedAt(const Sample& sample) {
  constexpr double kRounding = 1e-9;  // 8 ms as a difference of sums
  std::size_t first = 0;
  while (first + 1 < count_ &&
         sample.time - samples_[first + 1].time >= kBaselineSeconds - kRounding) {
    ++first;
  }
  std::shift_left(samples_.begin(), samples_.begin() + static_cast<std::ptrdiff_t>(count_),
                  static_cast<std::ptrdiff_t>(first));
  count_ -= first;
  const double seconds = sample.time - samples_[0].time;
  const bool enough = seconds >= kBaselineSeconds - kRounding;
  return enough ? glm::length(sample.degrees - samples_[0].degrees) / seconds : 0.0;
}

void SaccadeDetector::observe(double timeSeconds, const glm::dvec2& degrees) {
  const Sample sample{timeSeconds, degrees};
  if (count_ > 0) {
    const double step = timeSeconds - samples_[count_ - 1].time;
    if (!(step > 0.0)) return;
    if (step > kLongestGapSeconds) reset();
  }
  speed_ = count_ > 0 ? speedAt(sample) : 0.0;
  if (inSaccade_) {
    inSaccade_ = speed_ >= kOffsetShare * settings_.onsetSpeed &&
                 timeSeconds - onset_ <= kLongestSaccadeSeconds;
  } else if (speed_ >= settings_.onsetSpeed) {
    inSaccade_ = true;
    onset_ = samples_[0].time;
  }
  if (count_ == kMostSamples) {
    std::shift_left(samples_.begin(), samples_.end(), 1);
    --count_;
  }
  samples_[count_++] = sample;
}

}  // namespace macula::gaze
