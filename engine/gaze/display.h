// The display that a viewer sits before: what turns shares of a window into visual angles.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "engine/settings/registry.h"

namespace macula::gaze {

/// Size of the picture's area and how far the eyes are. By default a 27 inch display of 16:9 at
/// 75 cm: some 43 by 25 degrees.
struct Display {
  double widthMm = 597.0;
  double heightMm = 336.0;
  double distanceMm = 750.0;   ///< from the eyes to the display's middle
  bool sizeGiven = false;      ///< width or height by a setting, whatever its value
  bool distanceGiven = false;  ///< likewise
};

/// What a recording says of the display that it was made before.
class RecordedDisplay {
 public:
  /// Width and height; ignored where no display has them.
  void setSize(const glm::dvec2& millimetres);
  /// One distance of the eyes; ignored where no viewer sits so near or so far (codes for no eye).
  void noteDistance(double millimetres);

  [[nodiscard]] const std::optional<glm::dvec2>& sizeMm() const { return sizeMm_; }
  /// The mean of the distances; nothing where none was noted.
  [[nodiscard]] std::optional<double> distanceMm() const;

 private:
  std::optional<glm::dvec2> sizeMm_;
  double distanceSumMm_ = 0.0;
  std::size_t distances_ = 0;
};

/// The display that degrees are computed with, and who said its size and distance: "setting",
/// "file", or "assumed" where neither did.
struct KnownDisplay {
  Display display;
  std::string_view sizeBy = "assumed";
  std::string_view distanceBy = "assumed";
};

/// A setting goes before the file, and the file before the default.
[[nodiscard]] KnownDisplay knownDisplay(const Display& settings, const RecordedDisplay& file = {});

/// "597x336 mm (assumed) at 613 mm (file)".
[[nodiscard]] std::string describe(const KnownDisplay& known);

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
