// Only + - * / and square roots are used: they are exact everywhere, so the log is too.
#include "engine/gaze/synthetic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/random.h"

namespace macula::gaze {
namespace {

// A 27 inch display, 59.8 x 33.6 cm, 75 cm away; see kFoveaRadius.
constexpr glm::dvec2 kWindowDegrees{43.5, 25.2};

// Saccade duration = 21 ms + 2.2 ms a degree (Carpenter 1988, main sequence).
constexpr double kSaccadeBase = 0.021;
constexpr double kSaccadePerDegree = 0.0022;

// Fixations last 180 ms and longer, 340 ms on average (Henderson 2003: about 330 ms in scenes).
constexpr double kShortestFixation = 0.180;
constexpr double kFixationSpread = 0.640;  // times the product of two uniform numbers, mean 1/4

// People look near the centre of a scene (Tatler 2007): spread of fixations, in windows.
constexpr double kCentreBias = 0.18;
constexpr double kWindowMargin = 0.03;       // fixations on the scene keep off the very edge
constexpr double kGlanceShare = 1.0 / 24.0;  // share of fixations that leave the screen
constexpr double kGlancePlace = 1.06;        // x of such a glance, in windows

// Noise of a good remote tracker and slow drift of the eye, in degrees and degrees a second.
constexpr double kJitterDegrees = 0.12;
constexpr double kDriftSpeed = 0.3;

// Blinks close the eye for 100 to 250 ms. The lid covers the pupil before and uncovers it after,
// and the reported place runs down the screen by degrees although it is flagged valid.
constexpr double kShortestBlink = 0.100;
constexpr double kLongestBlink = 0.250;
constexpr double kBadBefore = 0.030;
constexpr double kBadAfter = 0.090;
constexpr double kBadDegreesBefore = 2.0;
constexpr double kBadDegreesAfter = 6.0;

constexpr double kShortestDropout = 0.350;
constexpr double kLongestDropout = 0.900;

constexpr double kPupilMean = 3.6;  // mm, in the light of a screen
constexpr double kPupilRange = 0.5;
constexpr double kPupilAdapt = 0.5;  // share of the way to a new size a second

struct Span {
  double begin = 0.0;
  double end = 0.0;
  [[nodiscard]] bool holds(double time) const { return time >= begin && time < end; }
};

double roundTo(double value, double unitsPerOne) {
  return std::floor(value * unitsPerOne + 0.5) / unitsPerOne;
}

/// The eye itself: fixations and saccades, without what the tracker makes of them.
class Eye {
 public:
  explicit Eye(const Random& random) : random_(random) { plan(0.0); }

  /// Where it looks, in windows; times must not decrease.
  [[nodiscard]] glm::dvec2 at(double time) {
    while (time >= saccade_.end) plan(saccade_.end);
    if (time < saccade_.begin) return from_ + drift_ * (time - fixationBegin_);
    // Minimum-jerk profile (Flash & Hogan 1985, for the arm; smooth start and stop).
    const double s = (time - saccade_.begin) / (saccade_.end - saccade_.begin);
    const double share = s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
    const glm::dvec2 start = from_ + drift_ * (saccade_.begin - fixationBegin_);
    return start + (to_ - start) * share;
  }

 private:
  /// Starts a fixation where the last saccade ended and plans the saccade after it.
  void plan(double begin) {
    from_ = to_;
    fixationBegin_ = begin;
    // Each draw on a line of its own: C++ leaves the order within an expression open.
    const double first = random_.uniform();
    const double second = random_.uniform();
    saccade_.begin = begin + kShortestFixation + kFixationSpread * first * second;
    const double driftX = random_.between(-kDriftSpeed, kDriftSpeed);
    const double driftY = random_.between(-kDriftSpeed, kDriftSpeed);
    drift_ = glm::dvec2(driftX, driftY) / kWindowDegrees;
    const double x = 0.5 + kCentreBias * random_.gauss();
    const double y = 0.5 + kCentreBias * random_.gauss();
    to_ = glm::clamp(glm::dvec2(x, y), kWindowMargin, 1.0 - kWindowMargin);
    if (random_.uniform() < kGlanceShare) to_.x = kGlancePlace;
    const double amplitude = glm::length((to_ - from_) * kWindowDegrees);
    saccade_.end = saccade_.begin + kSaccadeBase + kSaccadePerDegree * amplitude;
  }

  Random random_;
  glm::dvec2 from_{0.5};
  glm::dvec2 to_{0.5};
  glm::dvec2 drift_{0.0};
  double fixationBegin_ = 0.0;
  Span saccade_;
};

std::vector<Span> planBlinks(const SyntheticGazeOptions& options, Random random) {
  std::vector<Span> blinks;
  if (options.blinksPerMinute <= 0.0) return blinks;
  const double mean = 60.0 / options.blinksPerMinute;
  double time = 0.0;
  while (true) {
    time += random.between(0.5 * mean, 1.5 * mean);
    if (time >= options.durationSeconds) return blinks;
    const double end = time + random.between(kShortestBlink, kLongestBlink);
    blinks.push_back({time, end});
    time = end;
  }
}

/// One dropout in each of equal parts of the log, away from its ends.
std::vector<Span> planDropouts(const SyntheticGazeOptions& options, Random random) {
  std::vector<Span> dropouts;
  const double part = options.durationSeconds / std::max(options.dropouts, 1);
  for (int i = 0; i < options.dropouts; ++i) {
    const double begin = part * (i + random.between(0.3, 0.7));
    const double end = begin + random.between(kShortestDropout, kLongestDropout);
    dropouts.push_back({begin, end});
  }
  return dropouts;
}

/// How far, in degrees, the reported place lies below the true one around a blink.
double lidShift(const Span& blink, double time) {
  const double before = (time - (blink.begin - kBadBefore)) / kBadBefore;
  if (before > 0.0 && before < 1.0) return kBadDegreesBefore * before * before;
  const double after = ((blink.end + kBadAfter) - time) / kBadAfter;
  if (after > 0.0 && after <= 1.0) return kBadDegreesAfter * after * after;
  return 0.0;
}

void check(bool inRange, std::string_view option, std::string_view range) {
  if (!inRange) failInput("synthetic gaze: {} must be {}", option, range);
}

}  // namespace

GazeLog synthesizeGaze(const SyntheticGazeOptions& options) {
  check(options.durationSeconds >= 0.1 && options.durationSeconds <= 86400.0, "the duration",
        "0.1 to 86400 s");
  check(options.rateHz >= 1.0 && options.rateHz <= 10000.0, "the rate", "1 to 10000 Hz");
  check(options.blinksPerMinute >= 0.0 && options.blinksPerMinute <= 30.0, "the number of blinks",
        "0 to 30 a minute");
  check(options.dropouts >= 0 && options.dropouts <= 100, "the number of dropouts", "0 to 100");

  GazeLog log;
  log.name = "synthetic";
  log.format = "macula-csv";
  log.coordinates = {.unit = "0..1", .origin = "top left", .screenPixels = std::nullopt};
  log.notes = {
      fmt::format("SYNTHETIC gaze, made by a model and not recorded from a person (seed {}).",
                  options.seed),
      fmt::format("{} s at {} Hz: fixations, saccades, {} blinks a minute, {} dropouts.",
                  options.durationSeconds, options.rateHz, options.blinksPerMinute,
                  options.dropouts)};

  // A stream each, so that a blink more or less leaves the eye and the noise as they are.
  const std::vector<Span> blinks = planBlinks(options, Random(options.seed, 1));
  const std::vector<Span> dropouts = planDropouts(options, Random(options.seed, 2));
  Eye eye(Random(options.seed, 3));
  Random random(options.seed, 4);
  double pupil = kPupilMean;
  double pupilGoal = kPupilMean;

  const auto count = static_cast<std::size_t>(options.durationSeconds * options.rateHz);
  for (std::size_t i = 0; i < count; ++i) {
    const double time = roundTo(static_cast<double>(i) / options.rateHz, 1e6);
    // Drawn whether they are used or not, for the same reason.
    const double jitterX = random.gauss() * kJitterDegrees;
    const double jitterY = random.gauss() * kJitterDegrees;
    const double doubt = random.uniform();
    if (random.uniform() < 1.0 / options.rateHz) {
      pupilGoal = kPupilMean + random.between(-kPupilRange, kPupilRange);
    }
    pupil += (pupilGoal - pupil) * kPupilAdapt / options.rateHz;
    const glm::dvec2 place = eye.at(time);

    const auto holds = [&](const Span& span) { return span.holds(time); };
    const auto dropout = std::find_if(dropouts.begin(), dropouts.end(), holds);
    // Dropouts 1, 3, ... (from 0) are silent: some trackers write nothing at all.
    if (dropout != dropouts.end() && (dropout - dropouts.begin()) % 2 == 1) continue;

    GazeSample sample;
    sample.timeSeconds = time;
    sample.confidence = 0.0F;
    if (dropout == dropouts.end() && std::none_of(blinks.begin(), blinks.end(), holds)) {
      double shift = 0.0;
      for (const Span& blink : blinks) shift = std::max(shift, lidShift(blink, time));
      const glm::dvec2 seen = place + glm::dvec2(jitterX, jitterY + shift) / kWindowDegrees;
      sample.position = {roundTo(seen.x, 1e5), roundTo(seen.y, 1e5)};
      sample.valid = true;
      const double confidence = shift > 0.0 ? 0.6 + 0.2 * doubt : 0.9 + 0.1 * doubt;
      sample.confidence = static_cast<float>(roundTo(confidence, 1e2));
      sample.pupilMillimetres = static_cast<float>(roundTo(pupil, 1e3));
    }
    log.samples.push_back(sample);
  }
  return log;
}

}  // namespace macula::gaze
