// Leaves, petals and fronds.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/mesh_builder.h"

namespace macula::scene {

/// How a leaf hangs: a curve in the upright plane through the stem.
struct Leaf {
  float turns;   ///< direction around the stem
  float length;  ///< metres
  float rise;    ///< slope at the stem
  float droop;   ///< how far it bends down, per length squared
  float width;   ///< metres, full
  glm::vec3 foot;
};

/// A leaf as a strip of two columns, folded along its middle. v runs from the tip (0) to the stem.
/// @param outline half the width at a share of the length, 0..1
template <typename Outline>
void addLeaf(Primitive& mesh, const Leaf& leaf, int segments, const glm::vec4& color,
             const Outline& outline) {
  constexpr float kFold = 0.25F;  // height of the rims over the middle, per half width
  const glm::vec2 turned = onCircle(leaf.turns);
  const glm::vec3 ahead{turned.x, 0.0F, -turned.y};
  const glm::vec3 across{turned.y, 0.0F, turned.x};
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i <= segments; ++i) {
    const float s = static_cast<float>(i) / static_cast<float>(segments);
    const float height = leaf.length * (leaf.rise * s - leaf.droop * s * s);
    const float slope = leaf.rise - 2.0F * leaf.droop * s;
    const glm::vec3 up = glm::normalize(glm::vec3(0.0F, 1.0F, 0.0F) - ahead * slope);
    const glm::vec3 middle = leaf.foot + ahead * (leaf.length * s) + glm::vec3(0.0F, height, 0.0F);
    const float half = 0.5F * leaf.width * outline(s);
    for (int side = -1; side <= 1; ++side) {
      const auto signedSide = static_cast<float>(side);
      const glm::vec3 p = middle + across * (half * signedSide) +
                          up * (kFold * half * static_cast<float>(side * side));
      addVertex(mesh, p, glm::normalize(up - across * (kFold * signedSide)),
                {0.5F + 0.5F * signedSide, 1.0F - s}, color);
    }
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(segments); ++i) {
    for (std::uint32_t j = 0; j < 2; ++j) {
      const std::uint32_t a = first + i * 3 + j;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + 4});
      mesh.indices.insert(mesh.indices.end(), {a, a + 4, a + 3});
    }
  }
}

}  // namespace macula::scene
