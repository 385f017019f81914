// The parts of the car. It stands on y = 0 with its nose towards +x, the middle at the origin.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "engine/scene/procedural/scene_builder.h"

namespace macula::scene::car {

inline constexpr float kNose = 2.1F;          // metres, along x
inline constexpr float kTail = -2.1F;         // metres
inline constexpr float kFrontAxle = 1.32F;    // metres
inline constexpr float kRearAxle = -1.28F;    // metres
inline constexpr float kWheelRadius = 0.32F;  // metres, with the tyre
inline constexpr float kArchRadius = 0.385F;  // of the openings in the body, metres
inline constexpr float kSill = 0.23F;         // height of the body's lower edge, metres
inline constexpr float kDoorFront = 0.56F;    // x of the door's gaps, metres
inline constexpr float kDoorBack = -0.46F;
inline constexpr float kYard = 4.6F;  // half the side of the paved yard, metres

/// The share of the livery, from sill to ridge, that the flank below the windows takes.
inline constexpr float kFlankShare = 0.29F;
inline constexpr float kWaistShare = 0.38F;  ///< and where the windows begin
inline constexpr float kRoofShare = 0.64F;   ///< and where they end and the roof begins

/// Materials that several parts share.
struct Palette {
  std::int32_t paint, glass, rubber, chrome, steel, dark, alloy, lamp, amber, red, plate, cobbles,
      bricks, stone, timber, bark, leaves;
};

[[nodiscard]] Palette makePalette(SceneBuilder& builder, std::uint64_t seed);

/// The livery, unwrapped: u from tail to nose, v from the sill on the left (-z) over the roof to
/// the sill on the right. Camouflage, stripes, start number, gaps of the doors and lids.
[[nodiscard]] Image livery(int size, std::uint64_t seed);
/// Rows of worn cobbles; repeats.
[[nodiscard]] Image cobbles(int size, std::uint64_t seed);
/// Brickwork, eight courses; repeats.
[[nodiscard]] Image bricks(int size, std::uint64_t seed);
/// A number plate of dark letters on white.
[[nodiscard]] Image numberPlate(int width, int height, std::uint64_t seed);

/// Body, windows and what hangs under them.
void addBody(SceneBuilder& builder, const Palette& palette);
/// A point on the body's flank and its outward direction, for parts fixed to it.
/// @param side -1 left, 1 right; @param share of the way from sill (0) to ridge (1)
[[nodiscard]] glm::vec3 onBody(float x, float side, float share);

/// Four wheels with tyres, spokes and brakes.
void addWheels(SceneBuilder& builder, const Palette& palette);
/// Lamps, grille, bumpers, mirrors, handles, wipers, plates, exhaust.
void addFittings(SceneBuilder& builder, const Palette& palette);
/// Ground, walls, the lattice roof over the car and a tree.
void addYard(SceneBuilder& builder, const Palette& palette, std::uint64_t seed);

}  // namespace macula::scene::car
