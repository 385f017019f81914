#include "engine/gaze/refiner.h"

#include <algorithm>

namespace macula::gaze {

GazeRefiner::GazeRefiner(const PipelineSettings& settings, const Display& display, bool live)
    : display_(display),
      filters_(settings.filter == FilterChoice::OneEuro ||
               (settings.filter == FilterChoice::Auto && live)),
      predicts_(settings.prediction == Prediction::Landing),
      detector_(settings.saccade),
      filter_(settings.oneEuro) {}

void GazeRefiner::reset() {
  detector_.reset();
  filter_.reset();
  predictor_.reset();
}

glm::dvec2 GazeRefiner::degreesOf(const glm::dvec2& place) const {
  const glm::dvec2 millimetres = (place - 0.5) * glm::dvec2(display_.widthMm, display_.heightMm);
  return glm::degrees(glm::atan(millimetres / display_.distanceMm));
}

glm::dvec2 GazeRefiner::placeOf(const glm::dvec2& degrees) const {
  // A predicted landing may lie beyond what a flat display can show.
  constexpr double kSteepest = 80.0;
  return placeOfAngles(glm::clamp(degrees, -kSteepest, kSteepest), display_);
}

glm::dvec2 GazeRefiner::refine(double timeSeconds, const glm::dvec2& place) {
  const glm::dvec2 degrees = degreesOf(place);
  detector_.observe(timeSeconds, degrees);
  glm::dvec2 refined = place;
  if (detector_.inSaccade()) {
    // Smoothing would drag the point behind the eye; it starts again where the eye comes to rest.
    filter_.reset();
    if (predicts_) refined = placeOf(predictor_.moving(timeSeconds, degrees));
  } else {
    predictor_.rest(timeSeconds, degrees);
    const double seconds = timeSeconds - lastTime_;
    if (seconds > SaccadeDetector::kLongestGapSeconds) filter_.reset();
    if (filters_) refined = placeOf(filter_.next(degrees, seconds));
  }
  lastTime_ = timeSeconds;
  return refined;
}

}  // namespace macula::gaze
