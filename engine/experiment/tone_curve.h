// The tone curves of shaders/lib/tonemap.glsl on the CPU, for images that are computed and not
// drawn.
#pragma once

#include <glm/glm.hpp>
#include <string_view>

namespace macula::experiment {

/// @param curve none, neutral (Khronos PBR Neutral, 2024) or aces (Narkowicz 2015)
/// @param linear RGB after exposure
/// @throws std::invalid_argument for another curve
[[nodiscard]] glm::vec3 toneCurve(std::string_view curve, const glm::vec3& linear);

}  // namespace macula::experiment
