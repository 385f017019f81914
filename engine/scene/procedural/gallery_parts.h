// The parts of the gallery. The hall is 12 m wide (x), 22 m long (z) and 6 m high, its floor at
// y = 0; the sun comes through windows in the wall at +x, the aisle runs along z.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "engine/core/random.h"
#include "engine/scene/procedural/scene_builder.h"

namespace macula::scene::gallery {

inline constexpr float kHalfWidth = 6.0F;    // metres
inline constexpr float kHalfLength = 11.0F;  // metres
inline constexpr float kHeight = 6.0F;       // metres
inline constexpr float kColumnX = 4.2F;      // of the two rows of columns
inline constexpr float kBay = 4.0F;          // from column to column, and from window to window
inline const glm::vec3 kBowlPlace{0.0F, 0.0F, -1.5F};

/// Materials that several parts share.
struct Palette {
  std::int32_t marble, wood, plaster, stone, bronze, brass, fabric, leather, pottery;
};

[[nodiscard]] Palette makePalette(SceneBuilder& builder, std::uint64_t seed);

/// Floor, walls, ceiling, columns, windows, carpet.
void addHall(SceneBuilder& builder, const Palette& palette, std::uint64_t seed);

/// Benches, paintings, sculptures on plinths, chandeliers.
void addFurniture(SceneBuilder& builder, const Palette& palette, std::uint64_t seed);

/// Display cases, the table with vases, the partition, curtains.
void addGlass(SceneBuilder& builder, const Palette& palette, std::uint64_t seed);

/// Palms, broad-leaved plants, and the bowl with its smoke.
void addPlantsAndSmoke(SceneBuilder& builder, const Palette& palette, std::uint64_t seed);

}  // namespace macula::scene::gallery
