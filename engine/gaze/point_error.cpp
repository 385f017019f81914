#include "engine/gaze/point_error.h"

namespace macula::gaze {

GazeSettings undelayed(const GazeSettings& settings) {
  GazeSettings plain = settings;
  plain.latencyMs = 0.0;
  plain.pipeline.filter = FilterChoice::None;
  plain.pipeline.prediction = Prediction::None;
  return plain;
}

std::optional<double> pointError(const PointOfInterest& point, const PointOfInterest& truth,
                                 const Display& display) {
  if (truth.state != GazeState::Ok) return std::nullopt;
  return angleBetween(point.position, truth.position, display);
}

}  // namespace macula::gaze
