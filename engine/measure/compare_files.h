// Two image files and how far they are apart.
#pragma once

#include <filesystem>

#include "engine/measure/image_error.h"

namespace macula::measure {

/// Reads and compares two files on display values: PNG as stored, EXR and HDR clamped to 0..1 and
/// sRGB-encoded first; with options.hdr on linear values, for which a PNG is refused.
/// @throws InputError naming a file, see readImage() and compareImages().
[[nodiscard]] ImageError compareFiles(const std::filesystem::path& reference,
                                      const std::filesystem::path& test,
                                      const CompareOptions& options = {});

}  // namespace macula::measure
