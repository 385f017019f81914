#include "engine/control/work_estimate.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace macula::control {
namespace {

/// Spread that is assumed before it has been measured: GPU times of a still view vary by 1 to 2 %.
constexpr double kFirstSpread = 0.015;
/// Beyond as many spreads, and beyond the least share, a deviation is an outlier or a step: 1 in
/// 15,000 values of pure noise is.
constexpr double kGateSpreads = 4.0;
constexpr double kLeastGate = 0.05;
/// Weight of a new value: 20 values are averaged at rest, 2 where the level runs away.
constexpr double kGain = 0.1;
constexpr double kRunGain = 0.5;
/// As many deviations of one sign in a row are a drift: noise alone does it once in 32.
constexpr int kRun = 5;
/// Weight of a new value in the spread: some 60 values.
constexpr double kSpreadGain = 1.0 / 30.0;

}  // namespace

WorkEstimate::Outcome WorkEstimate::observe(double value) {
  if (!known_) {
    known_ = true;
    level_ = value;
    spread_ = kFirstSpread;
    return Outcome::First;
  }
  const double deviation = value / level_ - 1.0;
  const double gate = std::max(kGateSpreads * spread_, kLeastGate);
  if (std::abs(deviation) > gate) {
    const bool agrees = suspected_ && (suspect_ > level_) == (value > level_) &&
                        std::abs(value - suspect_) <= 2.0 * gate * std::max(value, suspect_);
    if (!agrees) {
      suspected_ = true;
      suspect_ = value;
      return Outcome::Outlier;
    }
    level_ = 0.5 * (value + suspect_);
    suspected_ = false;
    sameSign_ = 0;
    return Outcome::Stepped;
  }
  suspected_ = false;
  const int sign = deviation < 0.0 ? -1 : 1;
  sameSign_ = sign * sameSign_ > 0 ? sameSign_ + sign : sign;
  spread_ = std::sqrt(std::lerp(spread_ * spread_, deviation * deviation, kSpreadGain));
  level_ += (std::abs(sameSign_) >= kRun ? kRunGain : kGain) * deviation * level_;
  return Outcome::Followed;
}

}  // namespace macula::control
