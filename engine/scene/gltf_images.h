// Images of a glTF file: specification section 3.8.3.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "engine/scene/gltf_document.h"
#include "engine/scene/gltf_loader.h"

namespace macula::scene::gltf {

/// What the first bytes of an image file promise.
struct ImageHeader {
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  int bitsPerChannel = 8;
};

/// Size and depth from the header of a PNG or JPEG file; nothing where there is none.
[[nodiscard]] std::optional<ImageHeader> readImageHeader(std::span<const std::byte> bytes);

/// Decodes images one by one within the limits.
class ImageDecoder {
 public:
  ImageDecoder(Document& document, const GltfLimits& limits)
      : document_(document), limits_(limits) {}

  /// Image `index` of the file as 8-bit RGBA; nothing, and a warning, where it is missing, neither
  /// PNG nor JPEG, damaged or beyond the limits.
  [[nodiscard]] std::optional<Image> decode(std::size_t index);

 private:
  Document& document_;
  const GltfLimits& limits_;
  std::uint64_t bytes_ = 0;  // decoded so far
};

}  // namespace macula::scene::gltf
