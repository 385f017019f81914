#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/image/codec.h"

namespace macula::image::codec {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// Scanlines of these widths may be run-length coded a component at a time.
constexpr std::size_t kMinCodedWidth = 8;
constexpr std::size_t kMaxCodedWidth = 32767;

/// Mantissas are 0..255 and stand for 0..1 times 2^(exponent - 128): 128 + 8.
constexpr int kExponentBias = 136;

/// "-Y 512 +X 1024" as height and width.
std::optional<std::array<std::int64_t, 2>> parseResolution(std::string_view line) {
  std::array<std::int64_t, 2> sides{};
  constexpr std::array<std::string_view, 2> kAxes = {"-Y ", " +X "};
  for (std::size_t i = 0; i < 2; ++i) {
    if (!line.starts_with(kAxes[i])) return std::nullopt;
    line.remove_prefix(kAxes[i].size());
    const auto result = std::from_chars(line.data(), line.data() + line.size(), sides[i]);
    if (result.ec != std::errc{}) return std::nullopt;
    line.remove_prefix(static_cast<std::size_t>(result.ptr - line.data()));
  }
  if (!line.empty()) return std::nullopt;
  return sides;
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : path_(path), bytes_(readTextFile(path)) {}

  ImageF read() {
    readHeader();
    std::vector<Rgbe> row(static_cast<std::size_t>(image_.width));
    image_.pixels.reserve(sampleCount(image_));
    for (int y = 0; y < image_.height; ++y) {
      readRow(row);
      for (const Rgbe& pixel : row) {
        const float scale = pixel[3] == 0 ? 0.0F : std::ldexp(1.0F, int{pixel[3]} - kExponentBias);
        for (std::size_t c = 0; c < 3; ++c) {
          image_.pixels.push_back(static_cast<float>(pixel[c]) * scale);
        }
      }
    }
    return std::move(image_);
  }

 private:
  [[noreturn]] void failCut() const {
    failInput("{}: is cut off at byte {}; write it again", path_.string(), at_);
  }
  [[noreturn]] void failDamaged() const {
    failInput("{}: is damaged at byte {}; write it again", path_.string(), at_);
  }

  std::uint8_t next() {
    if (at_ >= bytes_.size()) failCut();
    return static_cast<std::uint8_t>(bytes_[at_++]);
  }

  Rgbe nextPixel() {
    Rgbe pixel{};
    for (std::uint8_t& byte : pixel) byte = next();
    return pixel;
  }

  std::string_view nextLine() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string::npos) failCut();
    const std::string_view line = std::string_view(bytes_).substr(at_, end - at_);
    at_ = end + 1;
    return line;
  }

  void readHeader() {
    constexpr std::string_view kFormat = "FORMAT=";
    for (std::string_view line = nextLine(); !line.empty(); line = nextLine()) {
      if (line.starts_with(kFormat) && line.substr(kFormat.size()) != "32-bit_rle_rgbe") {
        failInput("{}: holds '{}' pixels; give a picture of 32-bit_rle_rgbe", path_.string(),
                  line.substr(kFormat.size(), 40));
      }
    }
    const auto sides = parseResolution(nextLine());
    if (!sides) {
      failInput("{}: its resolution line is not '-Y height +X width'; write it again that way",
                path_.string());
    }
    checkHeader(path_, (*sides)[1], (*sides)[0], 3, bytes_.size());
    image_.width = static_cast<int>((*sides)[1]);
    image_.height = static_cast<int>((*sides)[0]);
    image_.channels = 3;
  }

  void readRow(std::span<Rgbe> row) {
    const bool mayBeCoded = row.size() >= kMinCodedWidth && row.size() <= kMaxCodedWidth;
    const std::size_t start = at_;
    const Rgbe first = nextPixel();
    if (!mayBeCoded || first[0] != 2 || first[1] != 2 || first[2] >= 128) {
      at_ = start;
      readPlainRow(row);
      return;
    }
    if (static_cast<std::size_t>(first[2] << 8 | first[3]) != row.size()) failDamaged();
    for (std::size_t component = 0; component < 4; ++component) readComponent(row, component);
  }

  /// Counts above 128 repeat one byte, others announce as many bytes.
  void readComponent(std::span<Rgbe> row, std::size_t component) {
    for (std::size_t x = 0; x < row.size();) {
      const std::uint8_t count = next();
      const bool run = count > 128;
      const std::size_t length = run ? count - 128U : count;
      if (length == 0 || length > row.size() - x) failDamaged();
      const std::uint8_t value = run ? next() : std::uint8_t{0};
      for (std::size_t i = 0; i < length; ++i) row[x++][component] = run ? value : next();
    }
  }

  /// Whole pixels; 1, 1, 1, n repeats the last one n times, times 256 for each such mark in a row.
  void readPlainRow(std::span<Rgbe> row) {
    int shift = 0;
    for (std::size_t x = 0; x < row.size();) {
      const Rgbe pixel = nextPixel();
      if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
        row[x++] = pixel;
        shift = 0;
        continue;
      }
      if (x == 0 || shift > 16) failDamaged();
      const std::size_t length = static_cast<std::size_t>(pixel[3]) << shift;
      if (length > row.size() - x) failDamaged();
      for (std::size_t i = 0; i < length; ++i, ++x) row[x] = row[x - 1];
      shift += 8;
    }
  }

  const std::filesystem::path& path_;
  const std::string bytes_;
  std::size_t at_ = 0;
  ImageF image_;
};

}  // namespace

ImageF readRadiance(const std::filesystem::path& path) {
  return Reader(path).read();
}

}  // namespace macula::image::codec
