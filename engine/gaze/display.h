// The display that a viewer sits before: what turns shares of a window into visual angles.
#pragma once

#include <glm/glm.hpp>

#include "engine/settings/registry.h"

namespace macula::gaze {

/// Size of the picture's area and how far the eyes are. By default a 27 inch display of 16:9 at
/// 75 cm: some 43 by 25 degrees.
struct Display {
  double widthMm = 597.0;
  double heightMm = 336.0;
  double distanceMm = 750.0;  ///< from the eyes to the display's middle
};

/// Registers `display.widthMm`, `display.heightMm` and `display.distanceMm`; `display` must outlive
/// the registry.
void registerSettings(settings::Registry& registry, Display& display);

/// Place on the display, 0..1 from the top left, of a gaze direction given as two angles from the
/// middle: x to the right and y down, in degrees, each less than 90 in size. The display is flat
/// and square to the line of sight to its middle, so a place is d tan(angle).
[[nodiscard]] glm::dvec2 placeOfAngles(const glm::dvec2& degrees, const Display& display);

/// Angle in degrees between the lines of sight to two places on the display (0..1, top left).
[[nodiscard]] double angleBetween(const glm::dvec2& a, const glm::dvec2& b, const Display& display);

}  // namespace macula::gaze
