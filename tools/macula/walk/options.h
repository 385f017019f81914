// Options of `macula walk`.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "engine/control/control_settings.h"
#include "engine/gaze/gaze_settings.h"
#include "engine/settings/registry.h"
#include "passes/render_settings.h"

namespace macula::tools {

struct WalkOptions {
  std::string scene;
  std::string size = "1280x720";
  std::string gaze = "mouse";       ///< or center, x,y, a log file, hid...
  std::string camera;               ///< auto, scene, a path file; empty: flown from the start
  int frames = 0;                   ///< 0: until the window is closed
  bool hidePanels = false;          ///< at first; a key shows them
  std::string panel = "view";       ///< tab that is open at first
  double uiScale = 0.0;             ///< 0: the monitor's content scale
  std::string script;               ///< file of steps; empty: none
  std::string screenshot;           ///< PNG of the window after the last frame; empty: none
  std::string json;                 ///< numbers of the last frame; empty: none
  std::string record;               ///< folder of a recording; empty: none
  bool recordHashes = false;        ///< the recording holds an image hash of each frame
  std::vector<std::string> probes;  ///< "x,y", 0..1 of the window from the top left
  passes::RenderSettings settings;
  gaze::GazeSettings gazeSettings;
  control::ControlSettings control;
  settings::Registry registry;
};

/// Opens the window and stays until it is closed or the frames are drawn.
void walk(WalkOptions& options);

}  // namespace macula::tools
