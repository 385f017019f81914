#include "engine/core/progress.h"

#include <fmt/format.h>

#include <utility>

namespace macula {
namespace {

/// "48 s", "3 min", "2.5 h": no finer than such an estimate is.
std::string durationText(double seconds) {
  constexpr double kMinute = 60.0;
  constexpr double kHour = 3600.0;
  constexpr double kMostOfAUnit = 1.5;  // from here on the next one reads better
  if (seconds < kMostOfAUnit * kMinute) return fmt::format("{:.0f} s", seconds);
  if (seconds < kMostOfAUnit * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.1f} h", seconds / kHour);
}

}  // namespace

ProgressLines::ProgressLines(std::string label, int total, Clock clock)
    : label_(std::move(label)),
      total_(total),
      clock_(std::move(clock)),
      begin_(clock_()),
      last_(begin_) {}

std::string ProgressLines::advance() {
  ++done_;
  const double now = clock_();
  if (done_ >= total_ || now - last_ < kProgressSeconds) return {};
  last_ = now;
  const double left = (now - begin_) / done_ * (total_ - done_);
  return fmt::format("{}: {}/{}, about {} left", label_, done_, total_, durationText(left));
}

}  // namespace macula
