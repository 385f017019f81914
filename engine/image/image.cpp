#include "engine/image/image.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/plural.h"
#include "engine/image/codec.h"

namespace macula::image {
namespace {

namespace fs = std::filesystem;

enum class Format : std::uint8_t { Png, Exr, Hdr };

/// Deflate, the densest coding of the three formats, makes at most 1032 bytes of one (RFC 1951:
/// 258 bytes in 2 bits). Four times that leaves room for the codings that EXR puts before it.
constexpr std::uintmax_t kMaxExpansion = 4096;

/// The bytes by which each format names itself.
constexpr std::string_view kPngMagic("\x89PNG\r\n\x1A\n", 8);
constexpr std::string_view kExrMagic("\x76\x2F\x31\x01", 4);
constexpr std::string_view kHdrMagics[] = {"#?RADIANCE", "#?RGBE"};

Format sniff(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    failInput("{}: cannot be read ({}); check its permissions", path.string(),
              std::strerror(errno));
  }
  std::array<char, 16> head{};
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  const std::string_view start(head.data(), static_cast<std::size_t>(in.gcount()));
  if (start.starts_with(kPngMagic)) return Format::Png;
  if (start.starts_with(kExrMagic)) return Format::Exr;
  for (const std::string_view magic : kHdrMagics) {
    if (start.starts_with(magic)) return Format::Hdr;
  }
  failInput("{}: {}; give a PNG, EXR or HDR image", path.string(),
            start.empty() ? "is empty" : "is no image that Macula reads");
}

/// A mistake in the program, not in its input.
template <typename Image>
void requireShape(const Image& image) {
  const bool sides =
      image.width >= 1 && image.height >= 1 && image.width <= kMaxSide && image.height <= kMaxSide;
  const bool depth = image.channels >= 1 && image.channels <= codec::kMaxChannels;
  if (!sides || !depth || image.pixels.size() != codec::sampleCount(image)) {
    throw std::invalid_argument("an image whose sides, channels and pixels do not agree");
  }
}

}  // namespace

void codec::checkHeader(const fs::path& path, std::int64_t width, std::int64_t height,
                        std::int64_t channels, std::uintmax_t fileBytes) {
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide) {
    failInput("{}: is {} x {} pixels; 1 x 1 to {} x {} can be read", path.string(), width, height,
              kMaxSide, kMaxSide);
  }
  if (channels < 1) failInput("{}: holds no channels; write it again", path.string());
  const auto samples = static_cast<std::uintmax_t>(width) * static_cast<std::uintmax_t>(height) *
                       static_cast<std::uintmax_t>(std::min<std::int64_t>(channels, kMaxChannels));
  if (samples / kMaxExpansion > fileBytes) {
    failInput("{}: is damaged: its {} bytes cannot hold the {} x {} pixels that its header claims",
              path.string(), fileBytes, width, height);
  }
}

ImageF readImage(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) failInput("{}: no such file; check the path", path.string());
  if (!fs::is_regular_file(path, error)) {
    failInput("{}: is no plain file; name an image", path.string());
  }
  const Format format = sniff(path);
  const std::uintmax_t bytes = fs::file_size(path, error);
  if (error) failInput("{}: cannot be read ({})", path.string(), error.message());
  if (format == Format::Png) codec::checkPng(path);
  ImageF image = format == Format::Hdr   ? codec::readRadiance(path)
                 : format == Format::Png ? codec::readPng(path, bytes)
                                         : codec::readExr(path, bytes);
  image.linear = format != Format::Png;
  return image;
}

ImageF readHdr(const fs::path& path) {
  ImageF image = readImage(path);
  if (!image.linear) {
    failInput("{}: is a PNG, with display values; give a linear image (.hdr or .exr)",
              path.string());
  }
  if (image.channels < 3) {
    failInput("{}: has {}; give an image with R, G and B", path.string(),
              counted(static_cast<std::uint64_t>(image.channels), "channel"));
  }
  return image;
}

void writePng(const fs::path& path, const Image8& image) {
  requireShape(image);
  writeFileAtomically(path,
                      [&](const fs::path& temporary) { codec::writePng(temporary, path, image); });
}

void writeExr(const fs::path& path, const ImageF& image) {
  requireShape(image);
  writeFileAtomically(path,
                      [&](const fs::path& temporary) { codec::writeExr(temporary, path, image); });
}

Image8 toImage8(const ImageF& image) {
  requireShape(image);
  Image8 bytes{image.width, image.height, image.channels, {}};
  bytes.pixels.reserve(image.pixels.size());
  for (const float value : image.pixels) {
    const float inRange = value > 0.0F ? std::min(value, 1.0F) : 0.0F;  // NaN compares false
    bytes.pixels.push_back(static_cast<std::uint8_t>(std::lround(inRange * 255.0F)));
  }
  return bytes;
}

}  // namespace macula::image
