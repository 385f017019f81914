// What a person may say about a gaze log that the file itself does not, or says wrongly.
#pragma once

#include <string>

#include "engine/gaze/display.h"
#include "engine/settings/registry.h"

namespace macula::gaze {

/// Unit of coordinates; the enumerators are in the order of the setting's choices.
enum class GazeUnit { File, Pixels, Normalised, Degrees };
/// Where coordinates begin and which way y points: down, but up for BottomLeft and CentreUp.
enum class GazeOrigin { File, TopLeft, BottomLeft, Centre, CentreUp };
/// Unit of times.
enum class TimeUnit { File, Seconds, Milliseconds, Microseconds, Nanoseconds };

/// Settings of the log readers. What is left at its default is taken from the file, and asked for
/// by an error where the file does not say it.
struct LogOptions {
  std::string format = "auto";  ///< a name of gazeFormatNames(), or found by content
  GazeUnit unit = GazeUnit::File;
  GazeOrigin origin = GazeOrigin::File;
  TimeUnit timeUnit = TimeUnit::File;
  std::string screen = {};     ///< "1920x1080" in pixels; empty: from the file
  std::string sidecar = {};    ///< JSON of a BIDS recording; empty: beside the file
  double minConfidence = 0.6;  ///< Pupil Core: samples below it are lost, 0..1
  Display display = {};        ///< turns degrees into places
  /// Places in a scene camera's picture are taken for places on the display where degrees are asked
  /// for; otherwise they have no degrees.
  bool sceneCameraAsDisplay = false;
};

/// Registers `gaze.format`, `gaze.unit`, `gaze.origin`, `gaze.timeUnit`, `gaze.screen`,
/// `gaze.sidecar`, `gaze.minConfidence` and `gaze.sceneCameraAsDisplay`; `options` must outlive the
/// registry. `display.*` are registered by registerSettings(registry, options.display).
void registerSettings(settings::Registry& registry, LogOptions& options);

}  // namespace macula::gaze
