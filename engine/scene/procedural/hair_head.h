// The opaque part of the hair scene: a comic bust, about twice life size, that looks along +z.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/scene/procedural/scene_builder.h"

namespace macula::scene::head {

/// The skull is this ellipsoid; metres.
inline const glm::vec3 kCenter{0.0F, 1.5F, 0.0F};
inline const glm::vec3 kRadii{0.40F, 0.47F, 0.42F};
/// The ring around the beard.
inline const glm::vec3 kTie{0.0F, 0.80F, 0.56F};
inline constexpr float kTieRadius = 0.05F;

/// Face, bust, ring, wall and floor.
/// @return indices of the shapes added
[[nodiscard]] std::vector<std::uint32_t> addHead(SceneBuilder& builder, std::uint64_t seed);

}  // namespace macula::scene::head
