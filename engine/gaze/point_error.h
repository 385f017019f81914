// How far a point of interest is from the eye, in replay, where the log knows better.
#pragma once

#include <optional>
#include <vector>

#include "engine/gaze/gaze_settings.h"
#include "engine/gaze/log.h"
#include "engine/gaze/point_of_interest.h"

namespace macula::gaze {

/// The same settings without latency, filter and prediction: what the log itself says.
[[nodiscard]] GazeSettings undelayed(const GazeSettings& settings);

/// Whether settings are as undelayed() makes them, in a replay: then every error is 0.
[[nodiscard]] bool isUndelayed(const GazeSettings& settings);

/// Degrees of visual angle between a point of interest and the eye.
/// @param truth the point by undelayed() settings at the same time
/// @returns nothing where the eye's place is not known (truth not ok)
[[nodiscard]] std::optional<double> pointError(const PointOfInterest& point,
                                               const PointOfInterest& truth,
                                               const Display& display);

/// pointError() of every frame of a replay of the log, where it is known.
/// @param framesPerSecond > 0
[[nodiscard]] std::vector<double> pointErrors(const GazeLog& log, const GazeSettings& settings,
                                              double framesPerSecond);

/// How far saccades in progress are from where they land, in degrees: one entry for each sample
/// within a saccade whose end was seen.
struct LandingErrors {
  std::vector<double> unpredicted;  ///< the sample itself
  std::vector<double> predicted;    ///< by LandingPredictor, from the samples up to it
};
[[nodiscard]] LandingErrors landingErrors(const GazeLog& log, const GazeSettings& settings);

}  // namespace macula::gaze
