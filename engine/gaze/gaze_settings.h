// Settings of the gaze, registered under `gaze.` and `display.`.
#pragma once

#include "engine/gaze/display.h"
#include "engine/gaze/log_options.h"
#include "engine/gaze/one_euro.h"
#include "engine/gaze/saccade_detector.h"
#include "engine/settings/registry.h"

namespace macula::gaze {

/// Whether believed samples are smoothed.
enum class FilterChoice {
  Auto,     ///< One Euro for live trackers; nothing in replay, and for the mouse
  None,     ///< as recorded
  OneEuro,  ///< bypassed in saccades
};

/// Where the point goes while the eye is in a saccade.
enum class Prediction {
  None,     ///< along with the eye
  Landing,  ///< ahead, to where the saccade will land
};

/// From believed samples to the point of interest.
struct PipelineSettings {
  FilterChoice filter = FilterChoice::Auto;
  OneEuroSettings oneEuro;  ///< speeds in degrees of visual angle a second
  SaccadeSettings saccade;
  Prediction prediction = Prediction::None;
  bool widen = true;  ///< the fovea, where the gaze is old or in a saccade
  /// Added to every place, in shares of the window: takes out a calibration that has drifted.
  double offsetX = 0.0;
  double offsetY = 0.0;
};

struct GazeSettings {
  Display display;
  LogOptions log;  ///< its display is not used: `display` is
  PipelineSettings pipeline;
  double latencyMs = 0.0;  ///< >= 0; a frame knows gaze that is this much older
  int monitor = 0;  ///< that the tracker watches: 0 the one that the window is on, else the n-th
};

/// What a log is read by.
[[nodiscard]] LogOptions logOptionsOf(const GazeSettings& settings);

/// Registers all of them; `settings` must outlive the registry.
void registerSettings(settings::Registry& registry, GazeSettings& settings);

}  // namespace macula::gaze
