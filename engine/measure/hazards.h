// Pixels that come out otherwise where fragments take no turns.
#pragma once

#include <cstdint>

#include "engine/image/image.h"

namespace macula::measure {

/// Pixels that differ in any channel, by however little: those of kb-racy whose fragments got in
/// each other's way, against kb-fixed, which is the same method with turns.
/// @throws std::invalid_argument where the images differ in size or channels
[[nodiscard]] std::uint64_t countUnlikePixels(const image::Image8& a, const image::Image8& b);

}  // namespace macula::measure
