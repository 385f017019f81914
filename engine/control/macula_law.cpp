#include "engine/control/macula_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
/// A change of 1/r^2 by this share must show in the times.
constexpr double kEffectShare = 0.06;
/// The same between r = 1 and more: reconstruction is added there, and may cost what a small step
/// saves. A clock that does not follow sends r far at once, so that this is not rare.
constexpr double kSwitchShare = 0.5;
/// Changes are forgotten in some 50 of them.
constexpr double kEffectMemory = 0.98;
/// Of the change that the model expects, what must be seen, by as many standard deviations: it is
/// asked again and again, and one wrong answer ends the control.
constexpr double kLeastEffect = 0.5;
constexpr double kEffectSpreads = 6.0;
/// Changes after each of which it is found so before the control is switched off.
constexpr int kIneffective = 2;
/// Times are thought to spread by this much at least: their spread is learned while it is asked.
constexpr double kLeastSpread = 0.03;
/// A change counts as no more than so many times the expected one: a hitch beside a change of r
/// would outweigh all others.
constexpr double kMostEffect = 3.0;

}  // namespace

/// The slope of seen over expected changes, by least squares through the origin, judged by jumps of
/// r from one frame to the next: over longer times the load may change as well, and good control
/// keeps the time where it is.
void MaculaLaw::watchEffect(const FrameTimes& times) {
  const double pixels = 1.0 / (times.resize * times.resize);
  const double before = 1.0 / (watched_.resize * watched_.resize);
  const bool neighbours = watched_.totalMs > 0.0 && times.frame == watched_.frame + 1;
  const bool switches = (times.resize <= kLeastResize) != (watched_.resize <= kLeastResize);
  const double share = switches ? kSwitchShare : kEffectShare;
  if (neighbours && std::abs(pixels - before) >= share * std::max(pixels, before)) {
    const double expected = work_.level() * (pixels - before);
    const double most = kMostEffect * std::abs(expected);
    const double seen = std::clamp(times.totalMs - watched_.totalMs, -most, most);
    expectedSquares_ = kEffectMemory * expectedSquares_ + expected * expected;
    seenProducts_ = kEffectMemory * seenProducts_ + seen * expected;
    // Of a difference of two times.
    const double spread = std::max(total_.relativeSpread(), kLeastSpread);
    const double deviation = std::numbers::sqrt2 * spread * times.totalMs;
    const bool none = seenProducts_ + kEffectSpreads * deviation * std::sqrt(expectedSquares_) <
                      kLeastEffect * expectedSquares_;
    ineffective_ = none ? ineffective_ + 1 : 0;
  }
  watched_ = times;
}

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
  watchEffect(times);
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
  if (ineffective_ >= kIneffective) {
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
  watched_ = {};
  return true;
}

}  // namespace macula::control
