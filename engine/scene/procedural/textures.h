// Small images computed in code. They use integers and exact float arithmetic only (no libm), so
// that their bytes are the same on every machine. Colours are sRGB, as glTF stores them.
#pragma once

#include <cstdint>

#include "engine/scene/scene.h"

namespace macula::scene {

/// Four marble slabs, light and dark in a chequer with veins; repeats.
[[nodiscard]] Image marbleTiles(int size, std::uint64_t seed);

/// Wood grain along v with boards side by side; repeats.
[[nodiscard]] Image woodBoards(int size, std::uint64_t seed);

/// Plaster: near white with faint mottling; repeats.
[[nodiscard]] Image plaster(int size, std::uint64_t seed);

/// A feathered frond from the stem (bottom) to the tip (top); alpha is 0 between the leaflets.
[[nodiscard]] Image frond(int size, std::uint64_t seed);

/// An abstract painting: a landscape of bands under a disc. Different for each seed.
[[nodiscard]] Image painting(int size, std::uint64_t seed);

/// A carpet with a border and a field of lozenges.
[[nodiscard]] Image carpet(int width, int height, std::uint64_t seed);

}  // namespace macula::scene
