#include "engine/scene/visibility.h"

#include <array>

namespace macula::scene {
namespace {

/// Part of w by which a corner must be outside: the GPU may round its positions differently.
constexpr float kMargin = 1e-4F;

}  // namespace

Bounds transformed(const Bounds& box, const glm::mat4& transform) {
  Bounds bounds;
  if (box.empty()) return bounds;
  for (unsigned corner = 0; corner < 8; ++corner) {
    bounds.add(glm::vec3(transform * glm::vec4(box.corner(corner), 1.0F)));
  }
  return bounds;
}

bool mayBeSeen(const Bounds& box, const glm::mat4& viewProjection) {
  if (box.empty()) return false;
  unsigned beyondAll = 0x3FU;  // a bit for each side
  for (unsigned corner = 0; corner < 8 && beyondAll != 0; ++corner) {
    const glm::vec4 p = viewProjection * glm::vec4(box.corner(corner), 1.0F);
    const float margin = kMargin * glm::abs(p.w);
    const std::array<float, 6> inside{p.w + p.x, p.w - p.x, p.w + p.y, p.w - p.y, p.z, p.w - p.z};
    unsigned beyond = 0;
    for (unsigned side = 0; side < inside.size(); ++side) {
      if (inside[side] < -margin) beyond |= 1U << side;
    }
    beyondAll &= beyond;
  }
  return beyondAll == 0;
}

}  // namespace macula::scene
