#define STB_IMAGE_STATIC  // other files hold copies of their own
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO

#include "engine/scene/gltf_materials.h"

// The header defines more static functions than this file calls.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <climits>
#include <memory>
#include <string>
#include <vector>

#include "engine/scene/gltf_uri.h"

namespace macula::scene::gltf {
namespace {

// A complete file cannot hold more pixels a byte: deflate expands at most 1032 times (its
// specification's window and codes), and a PNG row packs 8 pixels of one bit into a byte. JPEG,
// at 6 bits or more for 256 pixels, stays below.
constexpr std::uint64_t kMostPixelsPerByte = 1032 * 8;
constexpr std::uint64_t kMaxEncodedBytes = INT_MAX;  // the decoder takes an int

struct Free {
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

}  // namespace

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
  const auto* encoded = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int length = static_cast<int>(std::min<std::size_t>(bytes.size(), kMaxEncodedBytes));
  int width = 0;
  int height = 0;
  int channels = 0;
  if (stbi_info_from_memory(encoded, length, &width, &height, &channels) == 0 || width < 1 ||
      height < 1) {
    document_.warn(place, "not drawn: it is neither PNG nor JPEG, or damaged; save it as PNG");
    return std::nullopt;
  }
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  // The decoder counts bytes in an int.
  const bool wide = stbi_is_16_bit_from_memory(encoded, length) != 0;
  if (width > limits_.imageSide || height > limits_.imageSide ||
      pixels * (wide ? 8U : 4U) > INT_MAX) {
    document_.warn(place, "not drawn: {} x {} pixels are more than {} a side; scale it down", width,
                   height, limits_.imageSide);
    return std::nullopt;
  }
  if (bytes_ + 4 * pixels > limits_.imageBytes) {
    document_.warn(place, "not drawn: the images of the file exceed {} bytes; scale them down",
                   limits_.imageBytes);
    return std::nullopt;
  }
  std::unique_ptr<stbi_uc, Free> rgba;
  if (pixels / kMostPixelsPerByte <= bytes.size()) {
    rgba.reset(stbi_load_from_memory(encoded, length, &width, &height, &channels, STBI_rgb_alpha));
  }
  if (!rgba) {
    document_.warn(place, "not drawn: it is damaged; save it again as PNG or JPEG");
    return std::nullopt;
  }
  bytes_ += 4 * pixels;
  return Image{shownName, width, height, {rgba.get(), rgba.get() + 4 * pixels}};
}

}  // namespace macula::scene::gltf
