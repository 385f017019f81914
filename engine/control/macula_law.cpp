#include "engine/control/macula_law.h"

#include <algorithm>
#include <cmath>

namespace macula::control {
namespace {

/// Frames count as late beyond this much of the target.
constexpr double kTolerance = 1.02;
/// Spreads between the aim and a late frame: 1 in 200 frames of pure noise is later.
constexpr double kHeadroomSpreads = 2.6;
/// The aim is never above this share of the target, however calm the times are.
constexpr double kHighestAim = 0.995;
/// Changes of r below this share are not worth a new sampling pattern: it would shimmer.
constexpr double kDeadBand = 0.004;
/// Growth of the pixel number in a frame: half again as many in 5 frames, so that a spike of
/// optimism costs no late frame.
constexpr double kMostGrowth = 1.08;
/// Questions without times after which it is said: 30 frames are half a second.
constexpr int kSilentFrames = 30;

}  // namespace

void MaculaLaw::learn(const FrameTimes& times) {
  const double pixels = 1.0 / (times.resize * times.resize);
  const double resizable = times.resizableMs.value_or(times.totalMs);
  const double rest = std::max(times.totalMs - resizable, 0.0);
  const double modelled = work_.known() ? work_.level() * pixels + fixed_.level() : times.totalMs;
  if (resizable > 0.0) work_.observe(resizable / pixels);
  // A part that takes no time cannot be followed by shares of itself.
  constexpr double kLeastMs = 1e-3;
  fixed_.observe(std::max(rest, kLeastMs));
  total_.observe(times.totalMs / modelled);
  probe_.observe(times, work_.level());
}

double MaculaLaw::wanted() const {
  const double calm = kTolerance / (1.0 + kHeadroomSpreads * total_.relativeSpread());
  const double aim = targetMs_ * std::clamp(calm, leastAim_, kHighestAim);
  const double forWork = aim - fixed_.level();
  if (forWork <= 0.0) return mostResize_;
  return std::clamp(std::sqrt(work_.level() / forWork), kLeastResize, mostResize_);
}

double MaculaLaw::next(const FrameTimes* newest, double resize) {
  const bool fresh = newest != nullptr && newest->totalMs > 0.0 && std::isfinite(newest->totalMs) &&
                     (!sawFrame_ || newest->frame > lastFrame_);
  silent_ = fresh ? 0 : silent_ + 1;
  if (fresh) {
    sawFrame_ = true;
    lastFrame_ = newest->frame;
    learn(*newest);
  }
  if (probe_.failed()) {
    trouble_ = Trouble::NoEffect;
    return resize;
  }
  if (!work_.known() || silent_ >= kSilentFrames) {
    trouble_ = silent_ >= kSilentFrames ? Trouble::NoTimes : Trouble::None;
    return resize;
  }
  const double goal = wanted();
  const bool cpuBound = fresh && newest->cpuMs.value_or(0.0) > targetMs_;
  const bool late = work_.level() / (goal * goal) + fixed_.level() > kTolerance * targetMs_;
  trouble_ = goal >= mostResize_ && late ? Trouble::Unreachable
             : cpuBound                  ? Trouble::CpuBound
                                         : Trouble::None;
  const double work = work_.level() / (resize * resize);
  const double calm = moved(goal, resize);
  const double chosen = probe_.next(calm, resize, work / (work + fixed_.level()), fresh);
  if (chosen == calm) return calm;
  return std::clamp(inSteps(chosen, step_), kLeastResize, mostResize_);
}

double MaculaLaw::moved(double goal, double resize) const {
  if (std::abs(goal - resize) <= kDeadBand * resize && goal > kLeastResize) return resize;
  // One step down is allowed at any time: a coarser one than the growth would else never be left.
  const double grown = std::min(resize / std::sqrt(kMostGrowth), resize - step_);
  const double leastNow = std::max(grown, kLeastResize);
  return std::clamp(inSteps(std::max(goal, leastNow), step_), kLeastResize, mostResize_);
}

bool MaculaLaw::scalePixels(double ratio) {
  // Not all of the rest follows the pixels; two frames of the new size put that right.
  work_.scale(ratio);
  fixed_.scale(ratio);
  probe_.forgetTimes();
  return true;
}

}  // namespace macula::control
