// The order in which transparent triangles are drawn. It decides how many fragments a full k-buffer
// evicts and how often a sorted list is rearranged.
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
/// box, of a triangle to its centroid. Ties keep their order. A primitive with several
/// instances is sorted for the nearest one. Draws of different state (culling, textures, lit or
/// unlit) are still drawn run by run, so that the order holds within each run only.
/// @param seed of `Random`
void orderTransparent(Scene& scene, TransparentOrder order, std::uint64_t seed);

}  // namespace macula::scene
