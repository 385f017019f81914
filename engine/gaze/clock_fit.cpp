#include "engine/gaze/clock_fit.h"

#include <algorithm>
#include <cmath>

namespace macula::gaze {

ClockFit::ClockFit() {
  blocks_.reserve(kBlocks);
}

void ClockFit::restart(double deviceSeconds, double hostSeconds) {
  blocks_.clear();
  blocks_.push_back({});
  newest_ = 0;
  started_ = true;
  firstDevice_ = newestDevice_ = deviceSeconds;
  base_ = hostSeconds - deviceSeconds;
  intercept_ = slope_ = residual_ = 0.0;
}

void ClockFit::add(double deviceSeconds, double hostSeconds) {
  if (!std::isfinite(deviceSeconds) || !std::isfinite(hostSeconds)) return;
  if (!started_) return restart(deviceSeconds, hostSeconds);
  const double device = deviceSeconds - firstDevice_;
  const double delay = hostSeconds - deviceSeconds - base_;
  const double offLine = delay - intercept_ - slope_ * device;
  // Lateness alone is no sign of a new clock: a reader that stalled finds old samples late. A clock
  // that was set goes back, or ahead of the fit; one that stopped gets later without going on.
  const bool backward = deviceSeconds < newestDevice_ - kRestartSeconds;
  const bool early = offLine < -kRestartSeconds;
  const bool stopped = offLine > kRestartSeconds && deviceSeconds <= newestDevice_;
  if (backward || early || stopped) {
    ++restarts_;
    return restart(deviceSeconds, hostSeconds);
  }
  newestDevice_ = std::max(newestDevice_, deviceSeconds);

  Block& block = blocks_[newest_];
  if (device - block.start < kBlockSeconds) {
    if (delay >= block.delay) return;
    block.device = device;
    block.delay = delay;
  } else {
    // A clock that stood still for a while, or was set by little, leaves the line for good: even
    // the quickest arrival of a whole block lies off it.
    const double left = block.delay - intercept_ - slope_ * block.device;
    if (blocks_.size() > 1 && std::abs(left) > kStepSeconds) {
      ++restarts_;
      return restart(deviceSeconds, hostSeconds);
    }
    newest_ = (newest_ + 1) % kBlocks;
    if (newest_ == blocks_.size()) {
      blocks_.push_back({device, device, delay});
    } else {
      blocks_[newest_] = {device, device, delay};
    }
  }
  fit();
}

void ClockFit::fit() {
  // The newest block may not have had its quick arrival yet, and would tilt the line.
  const bool skipNewest = blocks_.size() > 1;
  const auto forEach = [&](auto&& visit) {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (!skipNewest || i != newest_) visit(blocks_[i]);
    }
  };
  const auto count = static_cast<double>(blocks_.size() - (skipNewest ? 1 : 0));
  double deviceMean = 0.0;
  double delayMean = 0.0;
  double quickest = blocks_[newest_].delay;
  forEach([&](const Block& block) {
    deviceMean += block.device / count;
    delayMean += block.delay / count;
    quickest = std::min(quickest, block.delay);
  });
  slope_ = 0.0;
  intercept_ = quickest;
  if (blocks_.size() > kBlocksForDrift) {
    double covariance = 0.0;
    double variance = 0.0;
    forEach([&](const Block& block) {
      covariance += (block.device - deviceMean) * (block.delay - delayMean);
      variance += (block.device - deviceMean) * (block.device - deviceMean);
    });
    slope_ = covariance / variance;
    intercept_ = delayMean - slope_ * deviceMean;
  }
  double squares = 0.0;
  forEach([&](const Block& block) {
    const double distance = block.delay - intercept_ - slope_ * block.device;
    squares += distance * distance;
  });
  residual_ = std::sqrt(squares / count);
}

std::optional<double> ClockFit::toHost(double deviceSeconds) const {
  if (!started_) return std::nullopt;
  return deviceSeconds + base_ + intercept_ + slope_ * (deviceSeconds - firstDevice_);
}

double ClockFit::driftPpm() const {
  constexpr double kMillion = 1e6;
  return slope_ * kMillion;
}

}  // namespace macula::gaze
