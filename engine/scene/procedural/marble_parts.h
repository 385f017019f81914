// The parts of the marble scene: a dragon coiled on a round plinth, its wings spread towards +-x,
// its head towards +z.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "engine/scene/procedural/scene_builder.h"

namespace macula::scene::marble {

inline constexpr float kPlinthTop = 0.40F;     // metres
inline constexpr float kPlinthRadius = 0.64F;  // of its upper rim, metres

/// Appends body, spikes and legs to `stone`, the wings' skin to `wings`.
/// @param seed varies the spikes
void addDragon(Primitive& stone, Primitive& wings, std::uint64_t seed);

/// Appends skull, jaws, teeth and horns. The eyes go to `eyes`.
/// @param frame right, up and forward of the head and where its neck ends; metres
void addHead(Primitive& stone, Primitive& eyes, const glm::mat4& frame);
/// Where the dragon's head begins.
[[nodiscard]] glm::mat4 headFrame();
/// The ball that the dragon holds: centre, and radius as w; metres.
inline constexpr glm::vec4 kBall{-0.115F, 0.93F, 0.36F, 0.095F};

/// A curved spike from `foot` over `middle` to a point at `tip`.
void addSpike(Primitive& mesh, const glm::vec3& foot, const glm::vec3& middle, const glm::vec3& tip,
              float radius, int segments = 6);

}  // namespace macula::scene::marble
