#include "engine/gaze/live_gaze.h"

#include <algorithm>
#include <utility>

namespace macula::gaze {
namespace {

constexpr double kStatusSeconds = 1.0;  ///< that rate and losses are counted over

}  // namespace

LiveGaze::LiveGaze(DeviceReader& reader, const GazeSettings& settings, double hostStart)
    : reader_(reader),
      display_(settings.display),
      hostStart_(hostStart),
      // The rate shows once the device runs.
      tracker_({.sampleInterval = 0.0,
                .latencySeconds = 0.0,
                .live = true,
                .pipeline = settings.pipeline,
                .display = settings.display}),
      recent_(kMostRecent) {
  samples_.reserve(kMostRecent);
}

void LiveGaze::place(const WindowPlacement& placement) {
  placement_ = placement;
  if (!(placement.monitorSize.x > 0.0) || !(placement.monitorSize.y > 0.0)) return;
  Display window = display_;
  window.widthMm *= placement.clientSize.x / placement.monitorSize.x;
  window.heightMm *= placement.clientSize.y / placement.monitorSize.y;
  tracker_.setDisplay(window);
}

void LiveGaze::learnInterval(double timeSeconds) {
  const double interval = timeSeconds - lastSample_;
  lastSample_ = timeSeconds;
  if (!(interval > 0.0)) return;
  intervals_[intervalCount_++ % kIntervals] = interval;
  const std::size_t have = std::min(intervalCount_, kIntervals);
  constexpr std::size_t kFewest = 3;
  if (have < kFewest) return;
  std::array<double, kIntervals> sorted = intervals_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(have / 2);
  std::nth_element(sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(have));
  tracker_.setSampleInterval(*middle);
}

GazeSample LiveGaze::toWindow(const DeviceSample& sample) {
  double host = sample.hostSeconds;
  if (sample.deviceSeconds) {
    judge_.add(*sample.deviceSeconds, sample.hostSeconds);
    clock_.add(*sample.deviceSeconds, sample.hostSeconds);
    if (judge_.believes()) {
      const double taken = clock_.toHost(*sample.deviceSeconds).value_or(host);
      host = std::clamp(taken, host - kOldestSeconds, host);
    }
  }
  GazeSample placed;
  placed.timeSeconds = host - hostStart_;
  placed.position = displayToWindow(sample.position, placement_);
  placed.valid = sample.valid;
  return placed;
}

void LiveGaze::forgetOldest() {
  valid_ -= recent_[oldest_].valid ? 1 : 0;
  oldest_ = (oldest_ + 1) % kMostRecent;
  --count_;
}

void LiveGaze::remember(const GazeSample& sample) {
  if (count_ == kMostRecent) forgetOldest();
  recent_[(oldest_ + count_++) % kMostRecent] = {sample.timeSeconds, sample.valid};
  valid_ += sample.valid ? 1 : 0;
}

PointOfInterest LiveGaze::at(double timeSeconds) {
  samples_.clear();
  reader_.drain(samples_);
  for (const DeviceSample& sample : samples_) {
    const GazeSample placed = toWindow(sample);
    if (listener_) listener_(placed);
    learnInterval(placed.timeSeconds);
    tracker_.observe(placed);
    remember(placed);
  }
  while (count_ > 0 && recent_[oldest_].time < timeSeconds - kStatusSeconds) forgetOldest();
  const bool connected = reader_.connected();
  // Unplugged: no silence has to be waited for.
  if (wasConnected_ && !connected) tracker_.lose(timeSeconds);
  wasConnected_ = connected;
  return tracker_.at(timeSeconds);
}

SourceStatus LiveGaze::status() const {
  SourceStatus status;
  status.live = true;
  status.connected = reader_.connected();
  status.rateHz = static_cast<double>(count_) / kStatusSeconds;
  if (count_ > 0) {
    status.lostShare = 1.0 - static_cast<double>(valid_) / static_cast<double>(count_);
  }
  status.message = reader_.message();
  if (judge_.believes()) {
    status.clock = ClockReport{.offsetSeconds = clock_.offsetSeconds(),
                               .driftPpm = clock_.driftPpm(),
                               .residualSeconds = clock_.residualSeconds(),
                               .restarts = clock_.restarts()};
  }
  if (judge_.verdict() == ClockJudge::Verdict::Wrong) {
    status.message += status.message.empty() ? "" : "; ";
    status.message += "its timestamps do not follow the time, so those of the host are used";
  }
  return status;
}

}  // namespace macula::gaze
