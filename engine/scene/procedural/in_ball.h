// Random points of a ball.
#pragma once

#include <glm/glm.hpp>

#include "engine/core/random.h"

namespace macula::scene {

/// Uniform in the unit ball, by rejection from its cube.
[[nodiscard]] inline glm::vec3 inBall(Random& random) {
  for (;;) {
    const float x = random.range(-1.0F, 1.0F);
    const float y = random.range(-1.0F, 1.0F);
    const float z = random.range(-1.0F, 1.0F);
    if (x * x + y * y + z * z <= 1.0F) return {x, y, z};
  }
}

}  // namespace macula::scene
