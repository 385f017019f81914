// What the renderer gets from the gaze: where to spend, and how far to trust it.
#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <string_view>

namespace macula::gaze {

/// How the point of interest came about.
enum class GazeState {
  Ok,      ///< the newest sample is trusted, and the point lies on it
  Held,    ///< the eye is lost for a short time; the point stays
  Lost,    ///< no eye: the point rests at the centre, or waits where it is for a returned eye
  Easing,  ///< on the way to the centre, or back to the eye
  None,    ///< no gaze has come yet
  Ended,   ///< the recording is over, and the point rests at the centre
};

/// "ok", "held", "lost", "easing", "none" or "ended", as reports write it.
[[nodiscard]] std::string_view stateName(GazeState state);

/// Radius of the fovea as a share of the window's height: 2.5 degrees (the fovea is about 5.2
/// degrees across; Wandell 1995) on a window that spans 25, such as a 27 inch display 75 cm away.
inline constexpr float kFoveaRadius = 0.1F;

/// Where the viewer looks in one frame.
struct PointOfInterest {
  glm::vec2 position{0.5F};  ///< 0..1 of the window from the top left, never outside
  /// The newest sample as it was recorded, outside 0..1 where it was; NaN where it held no place.
  glm::vec2 raw{std::numeric_limits<float>::quiet_NaN()};
  GazeState state = GazeState::None;
  /// Time since the last trusted sample was taken, >= 0; infinite where there was none.
  float ageSeconds = std::numeric_limits<float>::infinity();
  /// Share of the window's height: kFoveaRadius, and more where the gaze is old or in a saccade.
  float radius = kFoveaRadius;
  bool saccade = false;  ///< since the frame before, believed samples have been in a saccade
};

/// A point that is known exactly, such as one that was typed: state ok, age 0.
/// @param position 0..1 of the window; `position` of the result is clamped to it, `raw` is not
[[nodiscard]] PointOfInterest exactPoint(const glm::dvec2& position);

}  // namespace macula::gaze
