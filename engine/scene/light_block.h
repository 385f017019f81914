// The lights of a scene as shaders take them.
#pragma once

#include <vector>

#include "engine/scene/environment.h"
#include "engine/scene/scene.h"
#include "shared/scene_data.h"

namespace macula::scene {

[[nodiscard]] shader::LightData dataOf(const Light& light);

/// All light of a scene; of more lights than a frame takes, the first.
/// @param bounds of the scene · @param environment may be nullptr
[[nodiscard]] shader::LightBlock lightBlockOf(const Scene& scene, const Bounds& bounds,
                                              const Environment* environment);

/// World to clip space of the shadow map: an orthographic view from the light that casts shadows
/// around the whole scene, z 0..1; identity where no light casts any.
[[nodiscard]] glm::mat4 shadowViewProjectionOf(const Scene& scene, const Bounds& bounds);

/// Numbers of the materials with veins, in their order; kNone for the others.
[[nodiscard]] std::vector<std::int32_t> veinNumbers(const Scene& scene);

}  // namespace macula::scene
