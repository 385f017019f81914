// Options of `macula replay`.
#pragma once

#include <CLI/CLI.hpp>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "engine/gaze/gaze_settings.h"
#include "engine/measure/flip.h"
#include "engine/settings/registry.h"
#include "passes/render_settings.h"

namespace macula::tools {

struct ReplayOptions {
  std::string scene;
  std::string gaze = "center";
  std::string camera = "auto";
  int frames = 60;
  std::string size = "1024x1024";
  std::string out;
  bool force = false;  ///< --out may hold something else
  std::string images;  ///< "", "png" or "exr"
  std::string json;
  std::string platform = "auto";
  bool reference = false;
  bool hdr = false;
  double fps = 60.0;
  int warmup = 3;
  double pixelsPerDegree = measure::kDefaultPixelsPerDegree;  ///< of FLIP and eccentricity
  /// Options that were given and that a recording answers itself, as they are typed.
  std::vector<std::string> answeredByRecording;
  passes::RenderSettings settings;
  gaze::GazeSettings gazeSettings;
  settings::Registry registry;
};

/// Draws the frames and writes images and report. A folder in place of a scene is a recording.
void replay(ReplayOptions& options);

}  // namespace macula::tools
