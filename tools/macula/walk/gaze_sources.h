// The gaze sources that can be chosen while walking. Trackers are plugged in here.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/gaze/source.h"

namespace macula::tools {

/// A source as a list shows it.
struct GazeChoice {
  std::string spec;  ///< as --gaze takes it, and GazeSources::open()
  std::string note;  ///< one line: the device's maker and serial number; may be empty
};

struct GazeSources {
  /// The devices that are there now. Called on a thread of its own, about once a second.
  std::function<std::vector<GazeChoice>()> devices = [] { return std::vector<GazeChoice>{}; };
  /// Makes any source but the mouse. Called on a thread of its own, because logs may be large.
  /// @throws InputError naming the fix
  std::function<std::unique_ptr<gaze::GazeSource>(const std::string& spec,
                                                  const gaze::GazeSettings& settings)>
      open;
};

/// Logs, points and HID eye trackers.
[[nodiscard]] GazeSources allGazeSources();

}  // namespace macula::tools
