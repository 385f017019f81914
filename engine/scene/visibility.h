// Which boxes a view may show.
#pragma once

#include <glm/glm.hpp>

#include "engine/scene/scene.h"

namespace macula::scene {

/// World-space box around a box of an object.
[[nodiscard]] Bounds transformed(const Bounds& box, const glm::mat4& transform);

/// Whether a part of a box may be inside of the view: `false` where all of its corners are beyond
/// the same side of the frustum. Boxes beside a corner of the frustum may be called visible.
/// @param viewProjection world to clip space with z from 0 to w (View::viewProjection)
[[nodiscard]] bool mayBeSeen(const Bounds& box, const glm::mat4& viewProjection);

}  // namespace macula::scene
