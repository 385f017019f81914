// In which order transparent triangles are drawn: it decides what a k-buffer that fills up must
// throw out again, and how often a list is rearranged.
#pragma once

#include <cstdint>

#include "engine/scene/scene.h"

namespace macula::scene {

enum class TransparentOrder : std::uint8_t {
  File,       ///< as the scene says
  NearFirst,  ///< nearest to the first camera first
  FarFirst,
  Random,
};

/// Sorts transparent instances among the places that they hold in Scene::instances, and the
/// triangles of transparent primitives; opaque ones stay. Distances are from the first camera, or
/// from where the automatic orbit begins if there is none: of an instance to the middle of its
/// box, of a triangle to its centroid. Ties keep their order. A primitive that stands several times
/// is sorted as its nearest instance needs it. Draws of unlike state (culling, textures, lit or
/// unlit) are still drawn run by run, so only one material's worth of geometry comes in this order.
/// @param seed of `Random`
void orderTransparent(Scene& scene, TransparentOrder order, std::uint64_t seed);

}  // namespace macula::scene
