#include "engine/gaze/tracker.h"

#include <algorithm>
#include <cmath>

namespace macula::gaze {
namespace {

constexpr glm::dvec2 kCentre{0.5};

/// Whether the coordinates are gaze and not a code for "no eye".
bool isPlace(const glm::dvec2& p) {
  return p != glm::dvec2(0.0) && std::abs(p.x) <= kFarthestPlace && std::abs(p.y) <= kFarthestPlace;
}

/// Distance left after `seconds` of approach.
double easedDistance(double distance, double seconds) {
  constexpr double brakeFrom = kFastestEase * kFastestEase / (2.0 * kEaseDeceleration);
  constexpr double brakeTo = kSlowestEase * kSlowestEase / (2.0 * kEaseDeceleration);
  if (distance > brakeFrom) {
    const double duration = (distance - brakeFrom) / kFastestEase;
    if (seconds <= duration) return distance - kFastestEase * seconds;
    seconds -= duration;
    distance = brakeFrom;
  }
  if (distance > brakeTo) {
    // v = sqrt(2 a d), so sqrt(d) falls by sqrt(a / 2) a second.
    const double rate = std::sqrt(0.5 * kEaseDeceleration);
    const double duration = (std::sqrt(distance) - std::sqrt(brakeTo)) / rate;
    if (seconds <= duration) {
      const double root = std::sqrt(distance) - rate * seconds;
      return root * root;
    }
    seconds -= duration;
    distance = brakeTo;
  }
  return std::max(distance - kSlowestEase * seconds, 0.0);
}

}  // namespace

glm::dvec2 easeTowards(const glm::dvec2& point, const glm::dvec2& goal, double seconds) {
  const double distance = glm::length(goal - point);
  const double left = easedDistance(distance, seconds);
  return left <= 0.0 ? goal : goal + (point - goal) * (left / distance);
}

PointOfInterestTracker::PointOfInterestTracker(const TrackerOptions& options)
    : silenceLimit_(std::max(kSilenceIntervals * options.sampleInterval, kSilenceSeconds)),
      latency_(options.latencySeconds),
      widens_(options.pipeline.widen),
      offset_(options.pipeline.offsetX, options.pipeline.offsetY),
      refiner_(options.pipeline, options.display, options.live),
      fovea_(options.sampleInterval) {}

void PointOfInterestTracker::setSampleInterval(double seconds) {
  silenceLimit_ = std::max(kSilenceIntervals * seconds, kSilenceSeconds);
  fovea_.setSampleInterval(seconds);
}

double PointOfInterestTracker::holdEnd() const {
  return trustedAt_ + kHoldSeconds + kTimeTolerance;
}

void PointOfInterestTracker::advance(double time) {
  if (time <= now_) return;
  if (trust_ == Trust::Trusted && catchingUp_) {
    position_ = easeTowards(position_, gaze_, time - now_);
    catchingUp_ = position_ != gaze_;
  } else if (trust_ == Trust::Lost) {
    const double easeFrom = std::max({now_, lostAt_, holdEnd()});
    if (time > easeFrom) position_ = easeTowards(position_, kCentre, time - easeFrom);
  }
  now_ = time;
}

void PointOfInterestTracker::lose(double time) {
  if (trust_ == Trust::Lost) return;
  advance(time);
  trust_ = Trust::Lost;
  lostAt_ = now_;
  catchingUp_ = false;
  refiner_.reset();
}

void PointOfInterestTracker::noticeSilence(double time) {
  if (trust_ == Trust::NeverSeen) return;
  if (time - newestTime_ > silenceLimit_ + kTimeTolerance) lose(newestTime_ + silenceLimit_);
}

/// Keeps the run of samples at one place, lost ones included: Gazepoint repeats the last place
/// while it flags the loss, and a tracker may forget the flag.
bool PointOfInterestTracker::extendsFrozenRun(const GazeSample& sample) {
  if (sample.position != runPlace_) {
    runPlace_ = sample.position;
    runStart_ = sample.timeSeconds;
    runLength_ = 1;
    return false;
  }
  ++runLength_;
  return runLength_ >= kFrozenSamples &&
         sample.timeSeconds - runStart_ >= kFrozenSeconds - kTimeTolerance;
}

void PointOfInterestTracker::trust(const GazeSample& sample) {
  if (trust_ == Trust::Lost) {
    trust_ = Trust::Distrusted;
    returnedAt_ = sample.timeSeconds;
    heldAtReturn_ = sample.timeSeconds <= holdEnd();
  }
  if (trust_ == Trust::Distrusted) {
    if (sample.timeSeconds - returnedAt_ < kDistrustSeconds - kTimeTolerance) return;
    catchingUp_ = true;
  }
  trust_ = Trust::Trusted;
  trustedAt_ = sample.timeSeconds;
  gaze_ = glm::clamp(refiner_.refine(sample.timeSeconds, sample.position + offset_), 0.0, 1.0);
  saccadeSeen_ = saccadeSeen_ || refiner_.inSaccade();
  if (position_ == gaze_) catchingUp_ = false;
  if (!catchingUp_) position_ = gaze_;
}

void PointOfInterestTracker::observe(const GazeSample& sample) {
  if (!(sample.timeSeconds > newestTime_)) return;
  noticeSilence(sample.timeSeconds);
  advance(sample.timeSeconds);
  newestTime_ = sample.timeSeconds;
  raw_ = isPlace(sample.position) ? sample.position : kNoPosition;

  const bool frozen = extendsFrozenRun(sample);
  if (frozen) {
    // The repeats said nothing: what was trusted last is what was trusted before them.
    trustedAt_ = std::min(trustedAt_, trustedAtRunStart_);
  }
  if (frozen || !sample.valid || !isPlace(sample.position)) {
    lose(sample.timeSeconds);
  } else {
    trust(sample);
  }
  if (runLength_ <= 1) trustedAtRunStart_ = trustedAt_;
}

GazeState PointOfInterestTracker::state() const {
  switch (trust_) {
    case Trust::NeverSeen:
      return GazeState::None;
    case Trust::Trusted:
      return catchingUp_ ? GazeState::Easing : GazeState::Ok;
    case Trust::Distrusted:
      return heldAtReturn_ ? GazeState::Held : GazeState::Lost;
    case Trust::Lost:
      break;
  }
  if (now_ <= holdEnd()) return GazeState::Held;
  return position_ == kCentre ? GazeState::Lost : GazeState::Easing;
}

PointOfInterest PointOfInterestTracker::at(double time) {
  noticeSilence(time);
  advance(time);
  PointOfInterest point;
  point.position = glm::vec2(position_);
  point.raw = glm::vec2(raw_);
  point.state = state();
  const double age = now_ - trustedAt_ + latency_;
  point.ageSeconds = static_cast<float>(age);
  point.saccade = saccadeSeen_;
  saccadeSeen_ = refiner_.inSaccade();
  if (widens_) {
    // Where nothing has been seen yet there is no radius to go on from: the first sight sets it.
    point.radius = trust_ == Trust::NeverSeen
                       ? kFoveaRadius + static_cast<float>(FoveaRadius::kWidest)
                       : fovea_.at(now_, age, point.saccade);
  }
  return point;
}

}  // namespace macula::gaze
