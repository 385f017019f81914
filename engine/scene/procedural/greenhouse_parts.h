// The parts of the greenhouse. The house is 7 m wide (x), 18 m long (z) and 4.1 m high at its
// ridge, which runs along z over the aisle; the floor is at y = 0.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/scene/procedural/scene_builder.h"

namespace macula::scene::greenhouse {

inline constexpr float kHalfWidth = 3.5F;  // metres
inline constexpr float kFront = 5.0F;      // z of the near end wall
inline constexpr float kBay = 1.5F;        // metres from rafter to rafter
inline constexpr int kBays = 12;
inline constexpr float kBack = kFront - kBay * kBays;  // z of the far end wall
inline constexpr float kSill = 0.8F;                   // height of the brick base
inline constexpr float kEaves = 2.5F;
inline constexpr float kRidge = 4.1F;

/// Floor, brick base, bars, benches and what is seen through the glass, all opaque.
/// @return indices of the shapes that stand in front of other things
[[nodiscard]] std::vector<std::uint32_t> addHouse(SceneBuilder& builder, std::uint64_t seed);

/// The panes of walls and roof, one primitive for each tint. Where they stand, the returned meshes
/// stand too.
/// @return indices of the shapes added
[[nodiscard]] std::vector<std::uint32_t> addPanes(SceneBuilder& builder, std::uint64_t seed);

/// A tier of the benches, on both sides of the aisle.
struct Tier {
  float x;       ///< distance of its middle from the middle of the aisle
  float height;  ///< of its top
};
inline constexpr Tier kTiers[] = {{1.05F, 0.45F}, {1.75F, 0.80F}, {2.45F, 1.15F}, {3.05F, 1.5F}};

/// Plants to be placed: roots at the origin, 0.4 to 0.9 m high.
[[nodiscard]] std::vector<std::uint32_t> addPlantShapes(SceneBuilder& builder, std::uint64_t seed);

/// Plants that hang down from the origin.
[[nodiscard]] std::vector<std::uint32_t> addHangingShapes(SceneBuilder& builder,
                                                          std::uint64_t seed);

}  // namespace macula::scene::greenhouse
