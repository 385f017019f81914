#include "engine/gaze/clock_judge.h"

#include <cmath>

namespace macula::gaze {

void ClockJudge::add(double deviceSeconds, double hostSeconds) {
  if (!std::isfinite(deviceSeconds) || !std::isfinite(hostSeconds)) return;
  if (!started_) {
    started_ = true;
    hostBegin_ = hostSeconds;
    deviceBegin_ = deviceLast_ = deviceSeconds;
    return;
  }
  ++samples_;
  if (deviceSeconds > deviceLast_) ++advances_;
  deviceLast_ = deviceSeconds;
  const double hostSpan = hostSeconds - hostBegin_;
  const double deviceSpan = deviceSeconds - deviceBegin_;
  if (samples_ < kSpanSamples || hostSpan < kSpanSeconds) return;
  const bool moves = static_cast<double>(advances_) >= kAdvancing * static_cast<double>(samples_);
  const bool agrees = deviceSpan >= hostSpan / kTolerance && deviceSpan <= hostSpan * kTolerance;
  verdict_ = moves && agrees ? Verdict::Good : Verdict::Wrong;
  hostBegin_ = hostSeconds;
  deviceBegin_ = deviceSeconds;
  samples_ = advances_ = 0;
}

}  // namespace macula::gaze
