#include "engine/gaze/hid/device_clock.h"

namespace macula::gaze::hid {

std::optional<double> DeviceClock::check(double hostSeconds, std::optional<double> deviceSeconds) {
  if (!deviceSeconds) return std::nullopt;
  const double device = *deviceSeconds;
  if (!started_) {
    started_ = true;
    hostBegin_ = hostSeconds;
    deviceBegin_ = deviceLast_ = device;
    return std::nullopt;
  }
  ++reports_;
  if (device > deviceLast_) ++advances_;
  deviceLast_ = device;
  if (reports_ >= kClockSpanReports && hostSeconds - hostBegin_ >= kClockSpanSeconds) {
    judge(hostSeconds - hostBegin_, device - deviceBegin_);
    hostBegin_ = hostSeconds;
    deviceBegin_ = device;
    reports_ = advances_ = 0;
  }
  if (verdict_ != Verdict::Good) return std::nullopt;
  return deviceSeconds;
}

void DeviceClock::judge(double hostSpan, double deviceSpan) {
  const bool moves =
      static_cast<double>(advances_) >= kClockAdvancing * static_cast<double>(reports_);
  const bool agrees =
      deviceSpan >= hostSpan / kClockTolerance && deviceSpan <= hostSpan * kClockTolerance;
  verdict_ = moves && agrees ? Verdict::Good : Verdict::Wrong;
}

}  // namespace macula::gaze::hid
