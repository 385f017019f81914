// The parts of the chess scene. The board's upper side is y = 0, its middle the origin, White on
// the side of +z.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "engine/scene/procedural/scene_builder.h"

namespace macula::scene::chess {

inline constexpr float kSquare = 0.055F;  // side of a square, metres
inline constexpr float kBorder = 0.035F;  // of the frame around the squares, metres

enum class Kind : std::uint8_t { Pawn, Rook, Knight, Bishop, Queen, King };
inline constexpr std::size_t kKinds = 6;

/// One piece about the y axis, its foot at y = 0; it looks towards -z.
/// @param seed varies the knight's mane a little
void addPiece(Primitive& mesh, Kind kind, std::uint64_t seed);

/// The board from above: 8 x 8 squares with grain, light and dark in turn, and the border around
/// them in its share of the side.
[[nodiscard]] Image boardImage(int size, std::uint64_t seed);

}  // namespace macula::scene::chess
