#include "engine/gaze/one_euro.h"

#include <numbers>

namespace macula::gaze {
namespace {

/// Weight of the newest value in exponential smoothing with a cutoff frequency (2012, Eq. 3-4).
double smoothing(double cutoffHz, double seconds) {
  const double timeConstant = 1.0 / (2.0 * std::numbers::pi * cutoffHz);
  return 1.0 / (1.0 + timeConstant / seconds);
}

}  // namespace

glm::dvec2 OneEuro::next(const glm::dvec2& point, double seconds) {
  if (!started_) {
    started_ = true;
    filtered_ = point;
    velocity_ = glm::dvec2(0.0);
    return point;
  }
  const glm::dvec2 velocity = (point - filtered_) / seconds;
  velocity_ = glm::mix(velocity_, velocity, smoothing(settings_.derivativeCutoffHz, seconds));
  const double cutoff = settings_.minCutoffHz + settings_.beta * glm::length(velocity_);
  filtered_ = glm::mix(filtered_, point, smoothing(cutoff, seconds));
  return filtered_;
}

}  // namespace macula::gaze
