// From a place on the tracker's display to a place in the window.
#pragma once

#include <glm/glm.hpp>

namespace macula::gaze {

/// What the tracker's coordinates count; the origin is the upper left of its display.
enum class DeviceUnit {
  Share,        ///< 0..1 of the display
  Pixels,       ///< device pixels of the display
  Micrometres,  ///< of the calibrated display
};

/// The display and the window as the window system gives them. Positions and sizes count screen
/// coordinates, which some systems scale: `pixelsPerUnit` device pixels are one of them. (The
/// content scale for texts is another number: X11 has pixels as coordinates at any scale.)
struct WindowPlacement {
  glm::dvec2 monitorOrigin{0.0};  ///< of the tracker's display; negative left of or above the first
  glm::dvec2 monitorSize{1920.0, 1080.0};
  glm::dvec2 clientOrigin{0.0};  ///< of the window's inside, without title and frame
  glm::dvec2 clientSize{1920.0, 1080.0};
  double pixelsPerUnit = 1.0;

  bool operator==(const WindowPlacement&) const = default;
};

/// Where on the display, 0..1 from its upper left.
/// @param calibratedMicrometres size of the calibrated display; used with Micrometres only
[[nodiscard]] glm::dvec2 shareOfDisplay(const glm::dvec2& gaze, DeviceUnit unit,
                                        const WindowPlacement& placement,
                                        const glm::dvec2& calibratedMicrometres);

/// Where in the window, 0..1 from the top left of its inside; outside that where the gaze is off
/// the window. NaN where the window has no area.
/// @param share 0..1 of the display
[[nodiscard]] glm::dvec2 displayToWindow(const glm::dvec2& share, const WindowPlacement& placement);

}  // namespace macula::gaze
