// The gaze over the picture: a ring where it is and the fovea's extent around it, in the colour of
// its state.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "engine/gaze/point_of_interest.h"

namespace macula::tools {

/// Packed colour of a state, as Dear ImGui takes it.
[[nodiscard]] std::uint32_t colorOf(gaze::GazeState state);

/// @param low, size the picture's place in pixels of the window
void drawGazeCursor(const gaze::PointOfInterest& point, glm::vec2 low, glm::vec2 size);

}  // namespace macula::tools
