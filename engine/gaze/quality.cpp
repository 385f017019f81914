#include "engine/gaze/quality.h"

#include <algorithm>

namespace macula::gaze {
namespace {

/// Calls `visit(sample)` for each sample that is later than all before it.
template <typename Visit>
void forEachForward(const GazeLog& log, Visit visit) {
  const GazeSample* newest = nullptr;
  for (const GazeSample& sample : log.samples) {
    if (newest != nullptr && sample.timeSeconds <= newest->timeSeconds) continue;
    visit(sample);
    newest = &sample;
  }
}

bool onScreen(const glm::dvec2& p) {
  return p.x >= 0.0 && p.y >= 0.0 && p.x < 1.0 && p.y < 1.0;
}

double longestDropout(const GazeLog& log, double interval) {
  double longest = 0.0;
  // Before the first sample a valid one counts as due at the first, so that lost samples at the
  // start last as long as elsewhere.
  double lastValid = log.samples.front().timeSeconds - interval;
  double last = lastValid;
  forEachForward(log, [&](const GazeSample& sample) {
    last = sample.timeSeconds;
    if (!sample.valid) return;
    longest = std::max(longest, last - lastValid - interval);
    lastValid = last;
  });
  return std::max(longest, last - lastValid);
}

}  // namespace

double medianInterval(const GazeLog& log) {
  std::vector<double> intervals;
  intervals.reserve(log.samples.size());
  const GazeSample* previous = nullptr;
  forEachForward(log, [&](const GazeSample& sample) {
    if (previous != nullptr) intervals.push_back(sample.timeSeconds - previous->timeSeconds);
    previous = &sample;
  });
  if (intervals.empty()) return 0.0;
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

GazeQuality assess(const GazeLog& log) {
  GazeQuality quality;
  quality.samples = log.samples.size();
  if (log.samples.empty()) return quality;
  for (const GazeSample& sample : log.samples) {
    if (!sample.valid) ++quality.lost;
    if (sample.valid && !onScreen(sample.position)) ++quality.offScreen;
  }
  const double interval = medianInterval(log);
  if (interval > 0.0) quality.rateHz = 1.0 / interval;
  forEachForward(log, [&](const GazeSample& sample) {
    quality.durationSeconds = sample.timeSeconds - log.samples.front().timeSeconds;
  });
  quality.longestDropoutSeconds = longestDropout(log, interval);
  return quality;
}

}  // namespace macula::gaze
