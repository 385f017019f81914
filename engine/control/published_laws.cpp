#include "engine/control/published_laws.h"

#include <algorithm>
#include <numeric>

namespace macula::control {
namespace {

double limited(double resize, double most) {
  return std::clamp(resize, kLeastResize, most);
}

bool hasTime(const FrameTimes* times) {
  return times != nullptr && times->totalMs > 0.0;
}

/// r of a linear scale.
double ofScale(double scale, double most) {
  return limited(1.0 / std::max(scale, 1.0 / most), most);
}

}  // namespace

double YangLaw::next(const FrameTimes* newest, double resize) {
  constexpr double kMostChange = 0.2;
  if (!hasTime(newest)) return resize;
  const double pixels = 1.0 / (resize * resize) + (targetMs_ - newest->totalMs) / work_;
  // Eq. 4 asks for no pixels, or fewer, where the time is far over the target.
  const double goal = pixels > 0.0 ? 1.0 / std::sqrt(pixels) : mostResize_;
  return limited(std::clamp(goal, resize - kMostChange, resize + kMostChange), mostResize_);
}

double FilamentLaw::next(const FrameTimes* newest, double resize) {
  constexpr double kProportional = 0.1175;
  constexpr double kIntegral = 0.002;
  constexpr double kDeadLow = -0.01;
  constexpr double kDeadHigh = 0.05;
  if (!hasTime(newest)) return resize;
  times_[count_++ % kWindow] = newest->totalMs;
  if (count_ < kWindow) return resize;
  std::array<double, kWindow> sorted = times_;
  std::nth_element(sorted.begin(), sorted.begin() + kWindow / 2, sorted.end());
  const double error = 1.0 - sorted[kWindow / 2] / targetMs_;
  if (error > kDeadLow && error < kDeadHigh) return resize;
  const bool clamped =
      (resize <= kLeastResize && error > 0.0) || (resize >= mostResize_ && error < 0.0);
  if (!clamped) integral_ += error;
  const double out = kProportional * error + kIntegral * integral_;
  const double areaFactor = out < 0.0 ? 1.0 / (1.0 - out) : 1.0 + out;
  return limited(resize / std::sqrt(areaFactor), mostResize_);
}

double UnrealLaw::next(const FrameTimes* newest, double resize) {
  constexpr double kBudgetShare = 0.9;
  constexpr double kLeastChange = 0.02;
  constexpr int kLeastApart = 8;
  constexpr int kPanic = 2;
  ++sinceChange_;
  if (!hasTime(newest)) return resize;
  const double met = std::sqrt(kBudgetShare * targetMs_ / newest->totalMs) / newest->resize;
  scales_[count_++ % kWindow] = met;
  over_ = newest->totalMs > targetMs_ ? over_ + 1 : 0;
  if (over_ >= kPanic) {
    over_ = 0;
    count_ = 0;
    sinceChange_ = 0;
    return std::max(resize, ofScale(met, mostResize_));
  }
  // Newer frames weigh more, linearly.
  const std::size_t have = std::min(count_, kWindow);
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t age = 0; age < have; ++age) {
    const auto weight = static_cast<double>(kWindow - age);
    sum += weight * scales_[(count_ - 1 - age) % kWindow];
    weights += weight;
  }
  const double goal = ofScale(sum / weights, mostResize_);
  const bool enough = std::abs(goal / resize - 1.0) >= kLeastChange;
  if (!enough || sinceChange_ < kLeastApart || have < kWindow) return resize;
  sinceChange_ = 0;
  return goal;
}

double UnityLaw::next(const FrameTimes* newest, double resize) {
  constexpr int kFrames = 15;
  constexpr int kWindowsDown = 4;
  constexpr int kWindowsUp = 8;
  const double range = 1.0 - 1.0 / mostResize_;
  if (!hasTime(newest)) return resize;
  sum_ += newest->totalMs;
  if (++count_ < kFrames) return resize;
  const bool over = sum_ / kFrames > targetMs_;
  sum_ = 0.0;
  count_ = 0;
  overWindows_ = over ? overWindows_ + 1 : 0;
  underWindows_ = over ? 0 : underWindows_ + 1;
  double scale = 1.0 / resize;
  if (overWindows_ >= kWindowsDown) {
    overWindows_ = 0;
    scale -= 0.5 * range;
  } else if (underWindows_ >= kWindowsUp) {
    underWindows_ = 0;
    scale += 0.2 * range;
  }
  return ofScale(scale, mostResize_);
}

double IdLaw::next(const FrameTimes* newest, double resize) {
  constexpr double kDown = 0.11;
  constexpr double kUp = 0.06;
  constexpr int kFrames = 5;
  if (!hasTime(newest)) return resize;
  if (newest->totalMs > targetMs_) {
    under_ = 0;
    return ofScale(1.0 / resize - kDown, mostResize_);
  }
  if (++under_ < kFrames) return resize;
  under_ = 0;
  return ofScale(1.0 / resize + kUp, mostResize_);
}

}  // namespace macula::control
