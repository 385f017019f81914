// Images in memory, and as PNG, OpenEXR and Radiance HDR files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace macula::image {

/// Longest side of an image that is read or written, in pixels: twice that of OpenGL 4.5's least
/// GL_MAX_TEXTURE_SIZE, and enough for any environment map in use.
inline constexpr int kMaxSide = 32768;

/// Float pixels, interleaved, rows from the top.
struct ImageF {
  int width = 0;
  int height = 0;
  int channels = 0;           ///< 1 grey, 2 grey + alpha, 3 RGB, 4 RGBA
  std::vector<float> pixels;  ///< width * height * channels
  bool linear = false;        ///< true: scene-linear values (EXR, HDR); false: display values (PNG)
};

/// 8-bit pixels, interleaved, rows from the top.
struct Image8 {
  int width = 0;
  int height = 0;
  int channels = 0;                  ///< as in ImageF
  std::vector<std::uint8_t> pixels;  ///< width * height * channels
};

/// Whether the image module reads and writes OpenEXR (it was built with OpenImageIO).
/// @throws InputError where the module is missing
[[nodiscard]] bool hasExr();

/// Reads PNG, OpenEXR or Radiance HDR, told apart by their first bytes. Values as stored: PNG
/// integers as k/255 or k/65535, without any curve, alpha not multiplied in; EXR and HDR as float.
/// Of an EXR the first part, its data window, and at most four channels (R, G, B, A first).
/// @throws InputError naming the file where it is missing, damaged, another format, empty or larger
/// than kMaxSide, or claims more pixels than its bytes can hold.
[[nodiscard]] ImageF readImage(const std::filesystem::path& path);

/// Reads a linear image (HDR or EXR) with at least three channels, for example an environment map.
/// @throws InputError as readImage(), and for display images and grey ones.
[[nodiscard]] ImageF readHdr(const std::filesystem::path& path);

/// Writes the bytes as they are: reading the file gives the same ones. No time, no program name, so
/// that equal images make equal files.
/// @throws InputError naming the path where it cannot be written; nothing half-written stays.
void writePng(const std::filesystem::path& path, const Image8& image);

/// Writes 32-bit floats, losslessly compressed (zip). Otherwise as writePng().
/// @throws InputError also where this build has no EXR.
void writeExr(const std::filesystem::path& path, const ImageF& image);

/// Clamps to 0..1 and rounds to the nearest of 255 steps; NaN becomes 0. No curve.
[[nodiscard]] Image8 toImage8(const ImageF& image);

}  // namespace macula::image
