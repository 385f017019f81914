// JPEG in memory, for pictures inside a report. Never for measured images: it is lossy.
#pragma once

#include <string>

#include "engine/image/image.h"

namespace macula::image {

/// The bytes of a JPEG file, by stb in every build.
/// @param image 1 or 3 channels
/// @param quality 1..100; above 90 colours keep their full resolution
/// @throws std::invalid_argument for an image of another shape
[[nodiscard]] std::string encodeJpeg(const Image8& image, int quality);

}  // namespace macula::image
