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
/// A change of 1/r^2 by this share must show in the times.
constexpr double kEffectShare = 0.06;
/// As many changes without effect switch the control off.
constexpr int kIneffective = 3;
/// Of the change that the model expects, what must be seen.
constexpr double kLeastEffect = 0.1;

}  // namespace

/// Judges by jumps of r from one frame to the next: over longer times the load may change as well,
/// and good control keeps the time where it is.
void MaculaLaw::watchEffect(const FrameTimes& times) {
  const double pixels = 1.0 / (times.resize * times.resize);
  const double before = 1.0 / (watched_.resize * watched_.resize);
  const bool neighbours = watched_.totalMs > 0.0 && times.frame == watched_.frame + 1;
  if (neighbours && std::abs(pixels - before) >= kEffectShare * std::max(pixels, before)) {
    const double expected = work_.level() * (pixels - before);
    const double seen = times.totalMs - watched_.totalMs;
    ineffective_ = seen * expected < kLeastEffect * expected * expected ? ineffective_ + 1 : 0;
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
  const double aim =
      targetMs_ *
      std::min(kHighestAim, kTolerance / (1.0 + kHeadroomSpreads * total_.relativeSpread()));
  const double forWork = aim - fixed_.level();
  if (forWork <= 0.0) return kMostResize;
  return std::clamp(std::sqrt(work_.level() / forWork), kLeastResize, kMostResize);
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
  trouble_ = goal >= kMostResize ? Trouble::Unreachable
             : cpuBound          ? Trouble::CpuBound
                                 : Trouble::None;
  if (std::abs(goal - resize) <= kDeadBand * resize && goal > kLeastResize) return resize;
  const double leastNow = std::max(resize / std::sqrt(kMostGrowth), kLeastResize);
  const double chosen = std::max(goal, leastNow);
  if (step_ <= 0.0) return chosen;
  // Where r comes in steps, the next one up: the one below would be late in every frame.
  constexpr double kRounding = 1e-9;
  return std::min(std::ceil(chosen / step_ - kRounding) * step_, kMostResize);
}

std::string MaculaLaw::notice() const {
  switch (trouble_) {
    case Trouble::NoTimes:
      return "control waits: no frame times arrive";
    case Trouble::NoEffect:
      return "control is off: frame times do not follow the resize factor, so the clock measures "
             "something else (a vsync, the CPU)";
    case Trouble::CpuBound:
      return "the CPU needs longer than the target; a lower resolution does not help";
    case Trouble::Unreachable:
      return "the target is out of reach at the largest resize factor";
    case Trouble::None:
      break;
  }
  return {};
}

}  // namespace macula::control
