#include "engine/gaze/point_error.h"

#include <algorithm>
#include <cmath>

#include "engine/gaze/refiner.h"
#include "engine/gaze/source.h"

namespace macula::gaze {
namespace {

/// After a loss the point is at the centre by then: held, and eased across a window.
constexpr double kRestSeconds = 2.0;

}  // namespace

GazeSettings undelayed(const GazeSettings& settings) {
  GazeSettings plain = settings;
  plain.latencyMs = 0.0;
  plain.pipeline.filter = FilterChoice::None;
  plain.pipeline.prediction = Prediction::None;
  return plain;
}

bool isUndelayed(const GazeSettings& settings) {
  // Auto filters live trackers only.
  return settings.latencyMs == 0.0 && settings.pipeline.filter != FilterChoice::OneEuro &&
         settings.pipeline.prediction == Prediction::None;
}

std::optional<double> pointError(const PointOfInterest& point, const PointOfInterest& truth,
                                 const Display& display) {
  if (truth.state != GazeState::Ok) return std::nullopt;
  return angleBetween(point.position, truth.position, display);
}

std::vector<double> pointErrors(const GazeLog& log, const GazeSettings& settings,
                                double framesPerSecond) {
  std::vector<double> errors;
  if (log.samples.empty()) return errors;
  ReplayGaze replay(log, settings);
  ReplayGaze truth(log, undelayed(settings));
  std::size_t following = 0;  // the first sample later than the frame
  double newest = 0.0;
  for (std::size_t frame = 0;; ++frame) {
    double time = static_cast<double>(frame) / framesPerSecond;
    while (following < log.samples.size() && log.samples[following].timeSeconds <= time) {
      newest = std::max(newest, log.samples[following].timeSeconds);
      ++following;
    }
    if (following == log.samples.size() && time > newest) break;
    // In a gap of days nothing is known, and the point has long come to rest.
    if (time > newest + kRestSeconds && following < log.samples.size()) {
      const double next = log.samples[following].timeSeconds;
      frame = static_cast<std::size_t>(std::ceil(next * framesPerSecond));
      time = static_cast<double>(frame) / framesPerSecond;
    }
    const PointOfInterest point = replay.at(time);
    // Before the first sample arrives there is no point that could be wrong.
    const auto error = pointError(point, truth.at(time), settings.display);
    if (error && point.state != GazeState::None) errors.push_back(*error);
  }
  return errors;
}

LandingErrors landingErrors(const GazeLog& log, const GazeSettings& settings) {
  LandingErrors errors;
  GazeSettings predicting = settings;
  predicting.pipeline.filter = FilterChoice::None;
  predicting.pipeline.prediction = Prediction::Landing;
  GazeRefiner refiner(predicting.pipeline, settings.display, false);
  struct Step {
    glm::dvec2 place;
    glm::dvec2 predicted;
  };
  std::vector<Step> saccade;
  double newest = -1.0;
  for (const GazeSample& sample : log.samples) {
    if (!(sample.timeSeconds > newest)) continue;
    if (sample.timeSeconds - newest > SaccadeDetector::kLongestGapSeconds) saccade.clear();
    newest = sample.timeSeconds;
    if (!sample.valid) {
      refiner.reset();
      saccade.clear();  // its end was not seen
      continue;
    }
    const glm::dvec2 refined = refiner.refine(sample.timeSeconds, sample.position);
    if (refiner.inSaccade()) {
      saccade.push_back({sample.position, refined});
      continue;
    }
    for (const Step& step : saccade) {
      errors.unpredicted.push_back(angleBetween(step.place, sample.position, settings.display));
      errors.predicted.push_back(angleBetween(step.predicted, sample.position, settings.display));
    }
    saccade.clear();
  }
  return errors;
}

}  // namespace macula::gaze
