// How far a point of interest is from the eye, in replay, where the log knows better.
#pragma once

#include <optional>

#include "engine/gaze/gaze_settings.h"
#include "engine/gaze/point_of_interest.h"

namespace macula::gaze {

/// The same settings without latency, filter and prediction: what the log itself says.
[[nodiscard]] GazeSettings undelayed(const GazeSettings& settings);

/// Degrees of visual angle between a point of interest and the eye.
/// @param truth the point by undelayed() settings at the same time
/// @returns nothing where the eye's place is not known (truth not ok)
[[nodiscard]] std::optional<double> pointError(const PointOfInterest& point,
                                               const PointOfInterest& truth,
                                               const Display& display);

}  // namespace macula::gaze
