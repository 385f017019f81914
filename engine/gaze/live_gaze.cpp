#include "engine/gaze/live_gaze.h"

#include <algorithm>
#include <utility>

namespace macula::gaze {
namespace {

constexpr double kStatusSeconds = 1.0;  ///< that rate and losses are counted over

}  // namespace

LiveGaze::LiveGaze(DeviceReader& reader, const GazeSettings& settings, double hostStart)
    : reader_(reader),
      hostStart_(hostStart),
      // The rate is not known before the device has run: the silence rule takes its least time.
      tracker_({.sampleInterval = 0.0,
                .latencySeconds = 0.0,
                .live = true,
                .pipeline = settings.pipeline,
                .display = settings.display}),
      recent_(kMostRecent) {
  samples_.reserve(kMostRecent);
}

GazeSample LiveGaze::toWindow(const DeviceSample& sample) {
  double host = sample.hostSeconds;
  if (sample.deviceSeconds) {
    clock_.add(*sample.deviceSeconds, sample.hostSeconds);
    if (clock_.usable()) {
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
  return status;
}

ClockReport LiveGaze::clock() const {
  return {clock_.offsetSeconds(), clock_.driftPpm(), clock_.residualSeconds(), clock_.restarts()};
}

}  // namespace macula::gaze
