// Options of `macula hold`.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "common.h"
#include "engine/control/control_settings.h"
#include "engine/gaze/gaze_settings.h"
#include "engine/settings/registry.h"
#include "passes/render_settings.h"

namespace macula::tools {

struct HoldOptions {
  bool plant = false;
  int seeds = 20;  ///< of the simulated GPU
  std::string scene;
  std::string gaze = "center";
  std::string camera = "auto";
  std::string size = "640x360";
  int frames = 300;
  double fps = 60.0;
  int warmup = 8;                     ///< frames that each load is measured by at first
  std::vector<std::string> loads;     ///< FRAME:TIMES, or none; empty: twice from the middle on
  std::optional<double> targetShare;  ///< of the full-rate time; else control.targetMs
  std::string out;
  bool force = false;  ///< --out may hold something else
  std::string json;
  std::string platform = "auto";
  passes::RenderSettings settings;
  gaze::GazeSettings gazeSettings;
  control::ControlSettings control;
  settings::Registry registry;
};

/// From a frame on, the shading is computed so many times over.
struct LoadStep {
  std::size_t frame = 0;
  int times = 1;
};

/// @param texts FRAME:TIMES, ascending; or "none" alone; or nothing for the default
/// @param frames of the run
/// @throws InputError naming --load
[[nodiscard]] std::vector<LoadStep> parseLoads(const std::vector<std::string>& texts, int frames);

/// Runs every law on every case of the simulated GPU; writes results and report where a folder is
/// named.
void holdPlant(const HoldOptions& options);

/// Holds the target on a scene, beside the same frames with a fixed r.
void holdScene(HoldOptions& options);

}  // namespace macula::tools
