#include "engine/gaze/viewing.h"

#include <fmt/format.h>

#include <cmath>

namespace macula::gaze {
namespace {

// Pixels are square, and borders are below this: what differs more is another display.
constexpr double kAspectTolerance = 0.05;

}  // namespace

Viewing viewingOf(const GazeLogHead& head, const LogOptions& options) {
  Viewing viewing{.display = knownDisplay(options.display, head.display)};
  if (isOfSceneCamera(head.coordinates)) {
    viewing.hasDegrees = options.sceneCameraAsDisplay;
    viewing.warnings.emplace_back(
        "gaze in the picture of a scene camera, not on a display: its 0..1 is taken for that of "
        "the window");
    return viewing;
  }
  if (!head.coordinates.screenPixels || head.coordinates.of != "screen") return viewing;
  const glm::dvec2 pixels = *head.coordinates.screenPixels;
  const Display& display = viewing.display.display;
  const double aspect = display.widthMm / display.heightMm;
  const double logged = pixels.x / pixels.y;
  if (std::abs(aspect / logged - 1.0) > kAspectTolerance) {
    viewing.warnings.push_back(fmt::format(
        "a display of {:g}x{:g} mm ({}) is {:.2f} times as wide as high, the log's screen of "
        "{:.0f}x{:.0f} px {:.2f}; degrees are off until --display.widthMm and --display.heightMm "
        "fit",
        display.widthMm, display.heightMm, viewing.display.sizeBy, aspect, pixels.x, pixels.y,
        logged));
  }
  return viewing;
}

}  // namespace macula::gaze
