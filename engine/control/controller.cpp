#include "engine/control/controller.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace macula::control {
namespace {

/// Work done four times takes four times as long; half of that allows for launch costs and noise.
constexpr double kLeastGrowth = 2.0;
/// r this close to its end is there: renderers round the size of what they shade to whole pixels.
constexpr double kEndShare = 0.05;
/// Times in a row without resizable work until r is thought to have none.
constexpr int kWorkless = 3;
/// A window that waits for longer than this share of the frame is held by its display.
constexpr double kWaitShare = 0.15;

}  // namespace

std::string clockFault(double once, double fourTimes) {
  const bool sound = std::isfinite(once) && std::isfinite(fourTimes) && once > 0.0 &&
                     fourTimes >= kLeastGrowth * once;
  if (sound) return {};
  return fmt::format(
      "control is off: no clock can be trusted, for work done once and four times took {:.3f} and "
      "{:.3f} ms",
      once, fourTimes);
}

Controller::Controller(const ControlSettings& settings, std::string fault)
    : settings_(settings), fault_(std::move(fault)) {
  makeLaw();
}

void Controller::makeLaw() {
  made_ = settings_;
  const bool on = fault_.empty() && made_.law != "off";
  law_ = on ? control::makeLaw(made_.law, lawOptionsOf(made_)) : nullptr;
  steps_.forgetTimes(asked_);
}

bool Controller::atEnd(double resize) const {
  return resize >= made_.mostResize * (1.0 - kEndShare);
}

bool Controller::resizeHasWork(const ControlWork& work) const {
  return work.resize && workless_ < kWorkless;
}

void Controller::observe(const FrameTimes& times) {
  newest_ = times.frame + 1;
  workless_ = times.resizableMs && *times.resizableMs <= 0.0 ? workless_ + 1 : 0;
  intervalMs_ = times.intervalMs.value_or(0.0);
  const double cpuMs = times.cpuMs.value_or(0.0);
  const double busyMs = times.overlapped ? std::max(times.totalMs, cpuMs) : times.totalMs + cpuMs;
  waitMs_ = intervalMs_ > 0.0 ? intervalMs_ - busyMs : 0.0;
  steps_.observe(times.frame, times.totalMs, !resizeWorks_ || atEnd(times.resize));
}

void Controller::moveResize(double wanted) {
  double& resize = values_[QualityControl::Resize];
  // Without a target there is nothing that other controls could take over.
  const double most = law_->holdsTarget() ? made_.mostResize : kMostResize;
  resize = std::clamp(wanted, kLeastResize, most);
  resize = std::clamp(inSteps(resize, made_.resizeStep), kLeastResize, most);
}

const ControlValues& Controller::next(const FrameTimes* newest, double usedResize,
                                      const ControlWork& given) {
  if (made_ != settings_) {
    if (made_.law != settings_.law) steps_.rest();
    makeLaw();
  }
  const std::uint64_t frame = asked_++;
  ControlWork work = given;
  work.fovea = work.fovea && made_.fovea;
  work.layers = work.layers && made_.layers;
  active_ = law_ != nullptr && law_->trouble() != Trouble::NoEffect;
  if (!active_) {
    values_ = {};
    steps_.rest();
    return values_;
  }
  const FrameTimes* known = newest != nullptr && newest->frame >= validFrom_ ? newest : nullptr;
  const bool fresh = known != nullptr && known->totalMs > 0.0 && std::isfinite(known->totalMs) &&
                     known->frame >= newest_;
  if (fresh) observe(*known);
  const double wanted = law_->next(known, usedResize);
  resizeWorks_ = resizeHasWork(work);
  if (law_->holdsTarget()) steps_.decide(frame, made_.targetMs, work);
  // Controls are released from the end: r waits at its own until the others rest.
  if (resizeWorks_) moveResize(steps_.engaged() ? made_.mostResize : wanted);
  steps_.apply(values_);
  return values_;
}

void Controller::resized(double pixelRatio) {
  if (law_ != nullptr && !law_->scalePixels(pixelRatio)) makeLaw();
  validFrom_ = asked_;
  steps_.forgetTimes(asked_);
}

void Controller::restart() {
  makeLaw();
  validFrom_ = asked_;
  values_ = {};
  steps_.rest();
  workless_ = 0;
}

std::string Controller::notice() const {
  if (made_.law == "off") return {};
  if (!fault_.empty()) return fault_;
  const Trouble trouble = law_->trouble();
  if (trouble == Trouble::NoEffect || trouble == Trouble::NoTimes) return noticeOf(trouble);
  if (steps_.exhausted()) {
    return fmt::format(
        "the target of {:.4g} ms is out of reach: {:.4g} ms with every quality control at its end",
        made_.targetMs, steps_.leastMs());
  }
  if (trouble == Trouble::CpuBound) return noticeOf(trouble);
  if (steps_.engaged()) {
    return fmt::format("r is {}; fovea's slope times {:.3g}, {:.3g} of the layers",
                       resizeWorks_ ? "at its end" : "without work",
                       values_[QualityControl::FoveaSlope], values_[QualityControl::LayerShare]);
  }
  if (!resizeWorks_) return "nothing is computed at 1/r here, so r stays";
  if (waitMs_ > kWaitShare * intervalMs_) {
    return fmt::format(
        "the window waits for its display: a frame every {:.1f} ms, {:.1f} of it waiting",
        intervalMs_, waitMs_);
  }
  return {};
}

}  // namespace macula::control
