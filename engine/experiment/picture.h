// Pictures of a report: smaller copies, data URIs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/image/image.h"

namespace macula::experiment {

/// The image with its longest side at most `longest`: every pixel the mean of the area that it
/// covers, of display values. Smaller images stay as they are.
[[nodiscard]] image::Image8 shrink(const image::Image8& image, int longest);

/// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::string_view bytes);

/// "data:image/jpeg;base64,..." of a PNG file, shrunk.
/// @throws InputError where the file cannot be read
[[nodiscard]] std::string pictureUri(const std::filesystem::path& png, int longest);

}  // namespace macula::experiment
