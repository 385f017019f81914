#include "engine/control/clock_probe.h"

#include <algorithm>
#include <cmath>

namespace macula::control {
namespace {

/// Pixels that a probe saves. It has to stand out from noise (1.5 % of the time spreads by 0.18 of
/// the change that is expected), and to be less than half the refresh period of a display.
constexpr double kProbeShare = 0.1;
/// Of ln(pixels): distance of r, and length of its path, from where times last followed, at which
/// it is probed. A law that swings between two periods keeps near, and travels far.
constexpr double kFar = 0.3;
constexpr double kTravelled = 0.7;
/// The path is forgotten in some 100 frames: noise alone never makes it long.
constexpr double kPathMemory = 0.99;
/// A time between is no answer for as many questions: 6 frames of dead time are not all.
constexpr int kWait = 12;
/// The same after an answer that says nothing: loads that jump between frames give many.
constexpr int kLongWait = 30;
/// Of the change that a probe should show: below it, the time has stayed...
constexpr double kStays = 0.2;
/// ...and between these it has followed. Pure noise falls in there twice as often.
constexpr double kLeastFollows = 0.5;
constexpr double kMostFollows = 1.3;
/// What an answer counts against stuck_: noise alone never adds up to kStuck.
constexpr double kFollowed = 3.0;
constexpr double kUnclear = 0.25;
constexpr double kStuck = 8.0;
/// Pixels beside a probe are equal up to this share (sizes are whole pixels), and differ from it by
/// more than that one.
constexpr double kEqualPixels = 0.02;
constexpr double kLeastStep = 0.06;
/// A step of r that the law made itself shows that times follow where the time comes as near as
/// this to the expected one, in shares of the time: a few spreads of usual noise.
constexpr double kAgrees = 0.06;
/// Without as much of the time in passes that follow r, nothing could be seen.
constexpr double kLeastWork = 0.25;
/// r that the law wants, and r of the newest times, lie within this much of the present one: else
/// the times of a step are still on their way, and may show that they follow.
constexpr double kCalm = 0.05;

bool follows(const FrameTimes& before, const FrameTimes& after) {
  return after.frame == before.frame + 1;
}

}  // namespace

void ClockProbe::confirm(double resize) {
  confirmed_ = resize;
  path_ = 0.0;
}

/// A second difference, so that a load that drifts meanwhile cancels.
/// @returns false where the last three frames are no probe
bool ClockProbe::judgeProbe(const Seen& newest, double workMs) {
  if (!older_ || !follows(older_->times, old_->times)) return false;
  const double beside = 0.5 * (older_->pixels() + newest.pixels());
  const double step = old_->pixels() - beside;
  // At r = 1 nothing is reconstructed: another kind of frame.
  const double least = std::min({older_->times.resize, old_->times.resize, newest.times.resize});
  if (std::abs(older_->pixels() / newest.pixels() - 1.0) > kEqualPixels ||
      std::abs(step) < kLeastStep * beside || least <= kLeastResize) {
    return false;
  }
  const double seen = old_->times.totalMs - 0.5 * (older_->times.totalMs + newest.times.totalMs);
  const double answer = seen / (workMs * step);
  wait_ = 0;
  if (std::abs(answer) < kStays) {
    stuck_ += 1.0;
  } else if (answer > kLeastFollows && answer < kMostFollows) {
    stuck_ = std::max(stuck_ - kFollowed, 0.0);
    confirm(newest.times.resize);
  } else {
    // Just above the end of a period every frame with fewer pixels falls into the one below. One
    // with more may be late, so only where others have shown nothing.
    upwards_ = stuck_ > 0.0 ? !upwards_ : true;
    stuck_ = std::max(stuck_ - kUnclear, 0.0);
    if (stuck_ == 0.0) wait_ = kLongWait;
  }
  return true;
}

/// Steps of the law say that times follow, or nothing: they come with changes of the load.
void ClockProbe::judgeStep(const Seen& newest, double workMs) {
  const double step = newest.pixels() - old_->pixels();
  const bool switches =
      (newest.times.resize <= kLeastResize) != (old_->times.resize <= kLeastResize);
  if (stuck_ > 0.0 || switches ||
      std::abs(step) < kLeastStep * std::max(newest.pixels(), old_->pixels())) {
    return;
  }
  const double expected = workMs * step;
  const double seen = newest.times.totalMs - old_->times.totalMs;
  if (std::abs(seen - expected) <= kAgrees * old_->times.totalMs &&
      seen / expected > kLeastFollows) {
    confirm(newest.times.resize);
  }
}

void ClockProbe::observe(const FrameTimes& times, double workMs) {
  const Seen newest{times};
  if (!confirmed_) confirmed_ = times.resize;
  if (old_) {
    path_ = kPathMemory * path_ + 2.0 * std::abs(std::log(times.resize / old_->times.resize));
  }
  if (old_ && workMs > 0.0 && follows(old_->times, times) && !judgeProbe(newest, workMs)) {
    judgeStep(newest, workMs);
  }
  older_ = old_;
  old_ = newest;
}

bool ClockProbe::failed() const {
  return stuck_ >= kStuck;
}

double ClockProbe::next(double wanted, double resize, double workShare, bool fresh) {
  wait_ = std::max(wait_ - 1, 0);
  if (returnTo_) {
    // One frame at the old r, whatever the law wants by now: the probe lies between two alike.
    const double back = *returnTo_;
    returnTo_.reset();
    return back;
  }
  if (!fresh || !old_ || !confirmed_ || wait_ > 0) return wanted;
  const bool far = 2.0 * std::abs(std::log(resize / *confirmed_)) >= kFar || path_ >= kTravelled;
  const bool calm = std::abs(wanted - resize) < kCalm * resize &&
                    std::abs(old_->times.resize - resize) < kCalm * resize;
  if (!(far || stuck_ > 0.0) || !calm || resize <= kLeastResize || workShare < kLeastWork) {
    return wanted;
  }
  const double factor = 1.0 / std::sqrt(1.0 - kProbeShare);
  returnTo_ = resize;
  wait_ = kWait;
  const bool canRise = resize * factor <= mostResize_;
  const bool rises = canRise && (upwards_ || resize / factor <= kLeastResize);
  return rises ? resize * factor : resize / factor;
}

}  // namespace macula::control
