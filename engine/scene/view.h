// A camera as matrices.
#pragma once

#include <glm/glm.hpp>

#include "engine/scene/scene.h"

namespace macula::scene {

/// World to view to clip space. Depth is reversed (1 at the near plane, 0 at the far plane) and
/// clip space z is 0..1 (glClipControl), which spreads the precision of 32-bit floats evenly.
struct View {
  Camera camera;
  glm::mat4 view{1.0F};
  glm::mat4 projection{1.0F};
  glm::mat4 viewProjection{1.0F};
  glm::mat4 inverseViewProjection{1.0F};
};

/// @param aspect width / height, > 0
[[nodiscard]] View makeView(const Camera& camera, float aspect);

}  // namespace macula::scene
