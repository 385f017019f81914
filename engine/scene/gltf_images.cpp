#include "engine/scene/gltf_images.h"

#include <climits>
#include <string>
#include <utility>
#include <vector>

#include "engine/scene/gltf_uri.h"

namespace macula::scene::gltf {
namespace {

// A complete file cannot hold more pixels a byte: deflate expands at most 1032 times (its
// specification's window and codes), and a PNG row packs 8 pixels of one bit into a byte. JPEG,
// at 6 bits or more for 256 pixels, stays below.
constexpr std::uint64_t kMostPixelsPerByte = 1032 * 8;
constexpr std::uint64_t kMaxEncodedBytes = INT_MAX;  // the decoder takes an int

std::uint32_t byteAt(std::span<const std::byte> bytes, std::size_t i) {
  return std::to_integer<std::uint32_t>(bytes[i]);
}

std::uint32_t bigEndian(std::span<const std::byte> bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = (value << 8U) | byteAt(bytes, at + i);
  return value;
}

// PNG specification, sections 5.2 and 11.2.2: signature, then the IHDR chunk.
std::optional<ImageHeader> pngHeader(std::span<const std::byte> bytes) {
  constexpr std::size_t kHeaderEnd = 25;
  if (bytes.size() < kHeaderEnd || bigEndian(bytes, 0, 4) != 0x89504E47U ||
      bigEndian(bytes, 4, 4) != 0x0D0A1A0AU || bigEndian(bytes, 12, 4) != 0x49484452U) {
    return std::nullopt;
  }
  return ImageHeader{bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4),
                     static_cast<int>(byteAt(bytes, 24))};
}

// ITU T.81, annex B: markers up to the start of a frame.
std::optional<ImageHeader> jpegHeader(std::span<const std::byte> bytes) {
  if (bytes.size() < 4 || bigEndian(bytes, 0, 3) != 0xFFD8FFU) return std::nullopt;
  std::size_t at = 2;
  while (at + 9 <= bytes.size()) {
    if (byteAt(bytes, at) != 0xFFU) return std::nullopt;
    const std::uint32_t marker = byteAt(bytes, at + 1);
    if (marker == 0xFFU) {  // fill byte
      ++at;
      continue;
    }
    // SOF0..SOF15 without DHT, JPG and DAC, which share their range.
    if (marker >= 0xC0U && marker <= 0xCFU && marker != 0xC4U && marker != 0xC8U &&
        marker != 0xCCU) {
      return ImageHeader{bigEndian(bytes, at + 7, 2), bigEndian(bytes, at + 5, 2),
                         static_cast<int>(byteAt(bytes, at + 4))};
    }
    const std::size_t length = bigEndian(bytes, at + 2, 2);
    if (length < 2) return std::nullopt;
    at += 2 + length;
  }
  return std::nullopt;
}

// Takes over tinygltf's pixels; of 16 bits a channel the upper 8.
std::vector<std::uint8_t> toBytes(tinygltf::Image& decoded) {
  if (decoded.bits == 8) return std::move(decoded.image);
  std::vector<std::uint8_t> bytes(decoded.image.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    // Stored as little-endian 16-bit words.
    bytes[i] = decoded.image[2 * i + 1];
  }
  return bytes;
}

}  // namespace

std::optional<ImageHeader> readImageHeader(std::span<const std::byte> bytes) {
  if (const auto png = pngHeader(bytes)) return png;
  return jpegHeader(bytes);
}

std::optional<Image> ImageDecoder::decode(std::size_t index) {
  const ImageSource& source = document_.images[index];
  std::string shownName = source.name;
  if (shownName.empty() && !source.uri.starts_with("data:")) shownName = source.uri;
  const std::string place = shownName.empty() ? fmt::format("image {}", index)
                                              : fmt::format("image {} ({})", index, shownName);
  std::vector<std::byte> file;
  std::span<const std::byte> bytes;
  try {
    if (source.uri.empty()) {
      bytes = document_.viewBytes(source.bufferView, place);
    } else {
      file = readUri(source.uri, document_.folder, kMaxEncodedBytes);
      bytes = file;
    }
  } catch (const InputError& error) {
    document_.warn(place, "not drawn: {}", error.what());
    return std::nullopt;
  }
  const auto header = readImageHeader(bytes);
  if (!header || header->width == 0 || header->height == 0) {
    document_.warn(place, "not drawn: it is neither PNG nor JPEG, or damaged; save it as PNG");
    return std::nullopt;
  }
  const auto side = static_cast<std::uint64_t>(limits_.imageSide);
  const std::uint64_t pixels = header->width * header->height;
  // The decoder counts bytes, at 16 bits eight a pixel, in an int.
  const std::uint64_t decoderBytes = pixels * (header->bitsPerChannel > 8 ? 8U : 4U);
  if (header->width > side || header->height > side || decoderBytes > INT_MAX) {
    document_.warn(place, "not drawn: {} x {} pixels are more than {} a side; scale it down",
                   header->width, header->height, side);
    return std::nullopt;
  }
  if (bytes_ + 4 * pixels > limits_.imageBytes) {
    document_.warn(place, "not drawn: the images of the file exceed {} bytes; scale them down",
                   limits_.imageBytes);
    return std::nullopt;
  }
  tinygltf::Image decoded;
  std::string errors;
  std::string notes;
  if (bytes.size() > kMaxEncodedBytes || pixels / kMostPixelsPerByte > bytes.size() ||
      !tinygltf::LoadImageData(&decoded, static_cast<int>(index), &errors, &notes, 0, 0,
                               reinterpret_cast<const unsigned char*>(bytes.data()),
                               static_cast<int>(bytes.size()), nullptr)) {
    document_.warn(place, "not drawn: it is damaged; save it again as PNG or JPEG");
    return std::nullopt;
  }
  bytes_ += 4 * pixels;
  Image image;
  image.name = shownName;
  image.width = decoded.width;
  image.height = decoded.height;
  image.rgba = toBytes(decoded);
  return image;
}

}  // namespace macula::scene::gltf
