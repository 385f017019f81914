// Radiance HDR pictures (RGBE), read without a library: both builds then read the same values and
// a file that is cut off is always noticed.
#pragma once

#include <filesystem>

#include "engine/image/image.h"

namespace macula::image {

/// Reads a picture with the usual "-Y height +X width" order: three channels, each mantissa times
/// 2^(exponent - 136). EXPOSURE lines are left alone: values are as stored.
/// This work is based on G. Ward, "Real Pixels", Graphics Gems II, 1991, and on the description of
/// the file format in the Radiance manual ("File Formats", Pictures).
/// @throws InputError naming the file and the byte where it is damaged or cut off.
[[nodiscard]] ImageF readRadiance(const std::filesystem::path& path);

}  // namespace macula::image
