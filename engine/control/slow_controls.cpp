#include "engine/control/slow_controls.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace macula::control {
namespace {

/// A median beyond this much of the target asks for a step; the law calls frames late from there.
constexpr double kLate = 1.02;
/// A step is taken back where the time without it would still be below this share of the target.
constexpr double kRoom = 0.97;
/// The notice that a time is out of reach is repeated once that time differs by more than this: it
/// is no reading of a clock.
constexpr double kMoved = 0.1;

const ControlInfo& infoOf(QualityControl control) {
  return *std::ranges::find(kControlOrder, control, &ControlInfo::control);
}

double stepped(const ControlInfo& info, double value) {
  const double next = value * info.step;
  return info.end > info.rest ? std::min(next, info.end) : std::max(next, info.end);
}

}  // namespace

void SlowControls::observe(std::uint64_t frame, double totalMs, bool resizeEnded) {
  if (frame < since_) return;
  if (!resizeEnded) return forgetTimes(frame + 1);
  times_[count_++ % kWait] = totalMs;
}

void SlowControls::forgetTimes(std::uint64_t frame) {
  since_ = frame;
  count_ = 0;
  exhausted_ = false;
}

void SlowControls::rest() {
  steps_.clear();
  exhausted_ = false;
  count_ = 0;
}

bool SlowControls::take(std::uint64_t frame, const ControlWork& work) {
  ControlValues now;
  apply(now);
  for (const ControlInfo& info : kControlOrder) {
    if (info.step == 0.0 || !work[info.control] || now[info.control] == info.end) continue;
    steps_.push_back({info.control, medianMs_});
    forgetTimes(frame);
    return true;
  }
  return false;
}

void SlowControls::decide(std::uint64_t frame, double targetMs, const ControlWork& work) {
  // What has no work any more gives no time: back to rest, for when it has.
  if (std::erase_if(steps_, [&](const Step& step) { return !work[step.control]; }) > 0) {
    forgetTimes(frame);
  }
  if (count_ < kWait) return;
  std::array<double, kWait> sorted = times_;
  std::ranges::sort(sorted);
  medianMs_ = 0.5 * (sorted[(kWait - 1) / 2] + sorted[kWait / 2]);
  if (engaged() && steps_.back().gain == 0.0) {
    // The load may have changed beside it: a step that seems to have saved more than it can would
    // never be taken back.
    Step& step = steps_.back();
    step.gain = std::clamp(step.beforeMs / medianMs_, 1.0, infoOf(step.control).mostGain);
  }
  const bool before = std::exchange(exhausted_, false);
  if (medianMs_ > kLate * targetMs) {
    exhausted_ = !take(frame, work);
    const bool moved = std::abs(medianMs_ / leastMs_ - 1.0) > kMoved;
    if (exhausted_ && (!before || moved)) leastMs_ = medianMs_;
  } else if (engaged() && medianMs_ * steps_.back().gain < kRoom * targetMs) {
    steps_.pop_back();
    forgetTimes(frame);
  }
}

void SlowControls::apply(ControlValues& values) const {
  for (const ControlInfo& info : kControlOrder) {
    if (info.step != 0.0) values[info.control] = info.rest;
  }
  for (const Step& step : steps_)
    values[step.control] = stepped(infoOf(step.control), values[step.control]);
}

}  // namespace macula::control
