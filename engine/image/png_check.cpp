#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/image/codec.h"

namespace macula::image::codec {
namespace {

constexpr std::size_t kSignatureBytes = 8;
constexpr std::size_t kHeaderBytes = 13;  // of the IHDR chunk
constexpr std::size_t kFrameBytes = 12;   // length, type and CRC around a chunk's data

/// Four bytes, most significant first; the caller has checked that they are there.
std::uint32_t readWord(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = (word << 8) | static_cast<std::uint8_t>(bytes[at + i]);
  return word;
}

/// A bit depth that the colour type allows (table 11.1).
bool isHeader(std::string_view data) {
  if (data.size() != kHeaderBytes) return false;
  const auto bits = static_cast<std::uint8_t>(data[8]);
  const bool wide = bits == 8 || bits == 16;
  const bool narrow = bits == 1 || bits == 2 || bits == 4;
  const bool methods = data[10] == 0 && data[11] == 0 && (data[12] == 0 || data[12] == 1);
  switch (data[9]) {
    case 0:  // grey
      return methods && (wide || narrow);
    case 3:  // palette
      return methods && (bits == 8 || narrow);
    case 2:  // RGB
    case 4:  // grey and alpha
    case 6:  // RGBA
      return methods && wide;
    default:
      return false;
  }
}

}  // namespace

void checkPng(const std::filesystem::path& path) {
  const std::string file = readTextFile(path);
  const std::string_view bytes = file;
  for (std::size_t at = kSignatureBytes;;) {
    if (bytes.size() < at + kFrameBytes || bytes.size() - at - kFrameBytes < readWord(bytes, at)) {
      failInput("{}: is cut off: the part at byte {} is not whole; write it again", path.string(),
                at);
    }
    const std::size_t length = readWord(bytes, at);
    const std::string_view type = bytes.substr(at + 4, 4);
    const uLong checksum = crc32_z(0, reinterpret_cast<const Bytef*>(&bytes[at + 4]), 4 + length);
    if (checksum != readWord(bytes, at + 8 + length)) {
      failInput("{}: is damaged: the checksum of the part at byte {} is wrong; write it again",
                path.string(), at);
    }
    if (at == kSignatureBytes && (type != "IHDR" || !isHeader(bytes.substr(at + 8, length)))) {
      failInput("{}: is damaged: its header describes no PNG image; write it again", path.string());
    }
    if (at == kSignatureBytes) {
      checkHeader(path, readWord(bytes, at + 8), readWord(bytes, at + 12), 1, bytes.size());
    }
    if (type == "IEND") return;
    at += kFrameBytes + length;
  }
}

}  // namespace macula::image::codec
