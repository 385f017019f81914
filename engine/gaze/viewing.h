// What the places and degrees of one log are worth: on which display, said by whom, and what a
// person has to know before using them.
#pragma once

#include <string>
#include <vector>

#include "engine/gaze/display.h"
#include "engine/gaze/log.h"
#include "engine/gaze/log_options.h"

namespace macula::gaze {

struct Viewing {
  KnownDisplay display;  ///< what degrees are computed with
  /// False: a scene camera moves with the head, so that its picture is no display, and
  /// gaze.sceneCameraAsDisplay does not accept it as one.
  bool hasDegrees = true;
  std::vector<std::string> warnings = {};  ///< each one line, without the log's name
};

/// @param head of a log that has been read to its end
/// @param options with the display of the settings
[[nodiscard]] Viewing viewingOf(const GazeLogHead& head, const LogOptions& options);

/// Why a log has no degrees, and what to do, without the log's name.
inline constexpr const char* kNoDegrees =
    "places in a scene camera's picture have no degrees on a display; export gaze on a surface, or "
    "give --gaze.sceneCameraAsDisplay on with --display.* of the picture";

}  // namespace macula::gaze
