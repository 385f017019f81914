#include "engine/gaze/landing_predictor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace macula::gaze {
namespace {

// Amplitudes grow by a constant factor from 0.5 degrees, the size of a fixation's tremor, to some
// 50: larger ones are made by turning the head.
constexpr double kSmallest = 0.5;
constexpr double kGrowth = 1.06;
constexpr int kAmplitudes = 80;
// Onsets that are tried between the first sample and the newest.
constexpr int kOnsets = 24;
// Carpenter 1988: duration by amplitude.
constexpr double kSecondsPerDegree = 0.0022;
constexpr double kLeastSeconds = 0.021;
// Of a place, in degrees: what screen trackers state as precision, and what the model leaves over.
constexpr double kNoise = 0.3;
// Amplitudes in pictures: the middle one, and the spread of their logarithm (Bahill 1975: 86 % of
// natural saccades are below 15 degrees).
constexpr double kCommon = 6.0;
constexpr double kSpread = 0.9;

/// Share of the way covered at a share of the time.
double course(double u) {
  u = std::clamp(u, 0.0, 1.0);
  return u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
}

}  // namespace

void LandingPredictor::keep(double timeSeconds, const glm::dvec2& degrees) {
  if (count_ > 0 && timeSeconds - samples_[count_ - 1].time < kLeastStep) return;
  if (count_ == kMostSamples) {
    std::shift_left(samples_.begin(), samples_.end(), 1);
    --count_;
  }
  samples_[count_++] = {timeSeconds, degrees};
}

void LandingPredictor::forgetBefore(double timeSeconds) {
  std::size_t drop = 0;
  while (drop + 1 < count_ && samples_[drop + 1].time <= timeSeconds) ++drop;
  std::shift_left(samples_.begin(), samples_.begin() + static_cast<std::ptrdiff_t>(count_),
                  static_cast<std::ptrdiff_t>(drop));
  count_ -= drop;
}

void LandingPredictor::rest(double timeSeconds, const glm::dvec2& degrees) {
  moving_ = false;
  keep(timeSeconds, degrees);
}

glm::dvec2 LandingPredictor::moving(double timeSeconds, const glm::dvec2& degrees) {
  if (!moving_) forgetBefore(timeSeconds - kNoticedLate);
  moving_ = true;
  keep(timeSeconds, degrees);
  const glm::dvec2 from = samples_[0].degrees;
  const glm::dvec2 way = degrees - from;
  const double covered = glm::length(way);
  if (covered <= 0.0) return degrees;

  double best = covered;
  double least = std::numeric_limits<double>::infinity();
  double amplitude = kSmallest;
  for (int a = 0; a < kAmplitudes; ++a, amplitude *= kGrowth) {
    if (amplitude < covered) continue;  // the eye is farther already
    const double duration = kLeastSeconds + kSecondsPerDegree * amplitude;
    const double unlikely = std::log(amplitude / kCommon) / kSpread;
    for (int o = 0; o < kOnsets; ++o) {
      const double onset =
          std::lerp(samples_[0].time, timeSeconds, static_cast<double>(o) / kOnsets);
      double error = unlikely * unlikely;
      for (std::size_t i = 1; i < count_; ++i) {
        const double along = glm::dot(samples_[i].degrees - from, way) / covered;
        const double off =
            (amplitude * course((samples_[i].time - onset) / duration) - along) / kNoise;
        error += off * off;
      }
      if (error < least) {
        least = error;
        best = amplitude;
      }
    }
  }
  return from + way * (best / covered);
}

}  // namespace macula::gaze
