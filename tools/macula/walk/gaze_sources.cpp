#include "walk/gaze_sources.h"

#include <fmt/format.h>

#include "engine/core/error.h"
#include "engine/gaze/hid/hid_gaze.h"

namespace macula::tools {
namespace {

GazeChoice choiceOf(const gaze::hid::TrackerInfo& tracker) {
  GazeChoice choice;
  choice.spec = fmt::format("hid:{:04x}:{:04x}", tracker.vendorId, tracker.productId);
  if (!tracker.serial.empty()) choice.spec += ":" + tracker.serial;
  choice.note = oneLine(tracker.name);
  if (!tracker.accessible) choice.note += " (no permission; choose it to see how to grant it)";
  return choice;
}

}  // namespace

GazeSources allGazeSources() {
  GazeSources sources;
  sources.devices = [] {
    std::vector<GazeChoice> choices;
    for (const gaze::hid::TrackerInfo& tracker : gaze::hid::listTrackers()) {
      choices.push_back(choiceOf(tracker));
    }
    return choices;
  };
  sources.open = [](const std::string& spec, const gaze::GazeSettings& settings) {
    return gaze::hid::isTrackerSpec(spec) ? gaze::hid::openTracker(spec, settings)
                                          : gaze::parseGazeSpec(spec, settings);
  };
  return sources;
}

}  // namespace macula::tools
