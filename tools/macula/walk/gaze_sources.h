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
  /// The devices that are there now; called about once a second, so it must be quick.
  std::function<std::vector<GazeChoice>()> devices = [] { return std::vector<GazeChoice>{}; };
  /// Makes any source but the mouse. Called on a thread of its own, because logs may be large.
  /// @throws InputError naming the mend
  std::function<std::unique_ptr<gaze::GazeSource>(const std::string& spec)> open;
};

/// Logs, points and HID eye trackers.
/// @param settings are read on each open(), so that must outlive it
[[nodiscard]] GazeSources allGazeSources(const gaze::GazeSettings& settings);

}  // namespace macula::tools
