// What believed samples go through: saccade detection, filter, prediction.
#pragma once

#include <glm/glm.hpp>

#include "engine/gaze/gaze_settings.h"
#include "engine/gaze/landing_predictor.h"

namespace macula::gaze {

/// Turns believed places into the place where the viewer looks. Without filter and prediction it
/// gives back what it took, bit for bit, and only notices saccades. Places are 0..1 of the window;
/// inside it works in degrees of what `display` says the window is.
class GazeRefiner {
 public:
  /// @param live whether the samples come from a tracker now; decides FilterChoice::Auto
  GazeRefiner(const PipelineSettings& settings, const Display& display, bool live);

  /// Size and distance of the window, from now on.
  void setDisplay(const Display& display) { display_ = display; }
  /// The next believed sample.
  [[nodiscard]] glm::dvec2 refine(double timeSeconds, const glm::dvec2& place);
  /// Gaze was lost: nothing from before counts.
  void reset();

  [[nodiscard]] bool inSaccade() const { return detector_.inSaccade(); }

 private:
  [[nodiscard]] glm::dvec2 degreesOf(const glm::dvec2& place) const;
  [[nodiscard]] glm::dvec2 placeOf(const glm::dvec2& degrees) const;

  Display display_;
  bool filters_;
  bool predicts_;
  SaccadeDetector detector_;
  OneEuro filter_;
  LandingPredictor predictor_;
  double lastTime_ = 0.0;  ///< of the newest believed sample
};

}  // namespace macula::gaze
