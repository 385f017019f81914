#include "engine/gaze/quality.h"

#include <algorithm>
#include <cmath>

#include "engine/gaze/tracker.h"

namespace macula::gaze {
namespace {

// Steps of more than this many medians are losses, not jitter.
constexpr double kJitterMedians = 2.0;
// Times are differences of doubles: exact to this for recordings of days.
constexpr double kStepTolerance = 1e-8;
// A median of this many ticks is within 0.05 % of what it stands for.
constexpr double kFineTicks = 1000.0;
// A length of steps that is more seldom than one in so many comes from slips and losses.
constexpr std::size_t kRare = 20;
// Slower than any pursuit, faster than any eye.
constexpr settings::Range kThresholds{.min = 1.0, .max = 1000.0};

bool onScreen(const glm::dvec2& p) {
  return p.x >= 0.0 && p.y >= 0.0 && p.x < 1.0 && p.y < 1.0;
}

}  // namespace

void registerSettings(settings::Registry& registry, QualityOptions& options) {
  registry.add({.key = "gaze.ivtThreshold",
                .unit = "deg/s",
                .help = "from this speed on the eye is in a saccade"},
               options.ivtThreshold, kThresholds);
}

double medianInterval(const GazeLog& log) {
  std::vector<double> intervals;
  intervals.reserve(log.samples.size());
  const GazeSample* newest = nullptr;
  for (const GazeSample& sample : log.samples) {
    if (newest != nullptr && sample.timeSeconds <= newest->timeSeconds) continue;
    if (newest != nullptr) intervals.push_back(sample.timeSeconds - newest->timeSeconds);
    newest = &sample;
  }
  if (intervals.empty()) return 0.0;
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

QualityMeter::QualityMeter(const QualityOptions& options)
    : movements_(options.ivtThreshold, options.display) {}

void ClockTick::note(double step) {
  constexpr double kFinest = 1e-6;
  while (tick_ > 0.0) {
    const double ticks = step / tick_;
    if (std::abs(ticks - std::round(ticks)) * tick_ < kStepTolerance) return;
    // Rounded, so that tenths of tenths stay what they are called.
    tick_ = std::round(tick_ / 10.0 / kFinest) * kFinest;
  }
}

/// The nominal time between two samples. A clock of whole milliseconds gives 60 Hz as 16 and 17 ms,
/// of which the median is one and the mean the truth. Lost samples make steps of two intervals and
/// more, and stay out of the mean.
double QualityMeter::interval() const {
  using Steps = IntervalHistogram::Steps;
  const double median = intervals_.median();
  const double tick = tick_.seconds();
  if (median == 0.0 || tick == 0.0 || median > (kFineTicks - 0.5) * tick) return median;
  const double ticks = std::round(median / tick);
  const auto between = [&](double from, double to) {
    return intervals_.within((from - 0.25) * tick, (to + 0.25) * tick);
  };
  const auto mean = [](const Steps& a, const Steps& b) {
    return (a.seconds + b.seconds) / static_cast<double>(a.count + b.count);
  };
  if (ticks > 2.0) return mean(between(0.5 * ticks, 1.5 * ticks), {});
  // A step of one interval and one of two may differ by a tick: only the two lengths that a steady
  // tracker makes count, at 1200 Hz 1 ms and 0, a time that stands twice.
  const Steps same = between(ticks, ticks);
  const Steps longer = between(ticks + 1.0, ticks + 1.0);
  const Steps shorter =
      ticks > 1.0 ? between(ticks - 1.0, ticks - 1.0) : Steps{repeatedTimes_, 0.0};
  const Steps& other = shorter.count >= longer.count ? shorter : longer;
  return other.count * kRare < same.count ? median : mean(same, other);
}

void QualityMeter::countFrozen(const GazeSample& sample) {
  if (!(sample.position == frozenPlace_)) {  // also where there is none: NaN equals nothing
    frozenPlace_ = sample.position;
    frozenSince_ = sample.timeSeconds;
    frozenSamples_ = 0;
    frozenCounted_ = false;
  }
  ++frozenSamples_;
  const bool frozen = frozenSamples_ >= kFrozenSamples &&
                      sample.timeSeconds - frozenSince_ >= kFrozenSeconds - kTimeTolerance;
  if (frozen && !frozenCounted_) {
    ++counts_.frozenRuns;
    frozenCounted_ = true;
  }
}

void QualityMeter::add(const GazeSample& sample) {
  const double time = sample.timeSeconds;
  const bool first = counts_.samples == 0;
  ++counts_.samples;
  if (!sample.valid) ++counts_.lost;
  if (sample.valid && !onScreen(sample.position)) ++counts_.offScreen;
  if (!first && time == newest_) ++repeatedTimes_;
  if (!first && time <= newest_) return;
  if (first) {
    first_ = time;
  } else {
    intervals_.add(time - newest_);
    tick_.note(time - newest_);
  }
  newest_ = time;
  countFrozen(sample);
  movements_.add(time, sample.valid ? std::optional(sample.position) : std::nullopt);
  if (!sample.valid) return;
  if (anyValid_) {
    innerDropout_ = std::max(innerDropout_, time - lastValid_);
  } else {
    headDropout_ = time - first_;
  }
  anyValid_ = true;
  lastValid_ = time;
}

GazeQuality QualityMeter::quality() const {
  GazeQuality quality = counts_;
  if (counts_.samples == 0) return quality;
  const double interval = this->interval();
  if (interval > 0.0) quality.rateHz = 1.0 / interval;
  quality.durationSeconds = newest_ - first_;
  quality.jitterSeconds = intervals_.deviation(kJitterMedians * intervals_.median());
  quality.movements = movements_.result();
  // Lost samples at the start are due from the first one on; those at the end last as long as the
  // recording; a step between valid samples begins one interval after the former.
  const double atEnd = anyValid_ ? newest_ - lastValid_ : newest_ - first_ + interval;
  quality.longestDropoutSeconds = std::max({headDropout_, innerDropout_ - interval, atEnd, 0.0});
  return quality;
}

GazeQuality assess(const GazeLog& log, const QualityOptions& options) {
  QualityMeter meter(options);
  for (const GazeSample& sample : log.samples) meter.add(sample);
  return meter.quality();
}

}  // namespace macula::gaze
