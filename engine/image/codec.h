// What an image library must do for engine/image; one file of this folder does it in each build.
#pragma once

#include <cstdint>
#include <filesystem>

#include "engine/image/image.h"

namespace macula::image::codec {

/// Channels of a file beyond these are not read.
inline constexpr int kMaxChannels = 4;

/// Checks what a header claims, before anything of that size is allocated.
/// @param fileBytes length of the file
/// @throws InputError naming the file
void checkHeader(const std::filesystem::path& path, std::int64_t width, std::int64_t height,
                 std::int64_t channels, std::uintmax_t fileBytes);

/// width * height * channels of a checked image.
template <typename Image>
[[nodiscard]] std::size_t sampleCount(const Image& image) {
  return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
         static_cast<std::size_t>(image.channels);
}

/// Decode a file whose first bytes are those of the format; they call checkHeader(). A PNG has
/// passed checkPng().
[[nodiscard]] ImageF readPng(const std::filesystem::path& path, std::uintmax_t fileBytes);
[[nodiscard]] ImageF readExr(const std::filesystem::path& path, std::uintmax_t fileBytes);
/// Writes to `temporary`. @param path the final path, for messages
void writePng(const std::filesystem::path& temporary, const std::filesystem::path& path,
              const Image8& image);
void writeExr(const std::filesystem::path& temporary, const std::filesystem::path& path,
              const ImageF& image);

}  // namespace macula::image::codec
