// The codecs of engine/image.
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

/// Looks over a PNG before it is decoded: walks over its chunks (W3C PNG, 3rd edition, 5.3) and
/// checks that none is cut off, that every CRC is right, that the header and the end are there and
/// that its sides are allowed. Damage is found here with its place, before a decoder prints its own
/// words on it.
/// @throws InputError naming the file and the byte.
void checkPng(const std::filesystem::path& path);

/// Reads a Radiance HDR picture (RGBE) without a library. stb_image 2.27 never returns from some
/// that are cut off and misplaces rows where both codings are mixed; OpenImageIO 2.4 is not in
/// every build and knows no older runs. Takes the usual "-Y height +X width" order: three channels,
/// each mantissa times 2^(exponent - 136). EXPOSURE lines are left alone: values are as stored.
/// This work is based on G. Ward, "Real Pixels", Graphics Gems II, 1991, and on the description of
/// the file format in the Radiance manual ("File Formats", Pictures).
/// @throws InputError naming the file and the byte where it is damaged or cut off.
[[nodiscard]] ImageF readRadiance(const std::filesystem::path& path);

}  // namespace macula::image::codec
