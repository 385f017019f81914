// Materials, textures, samplers and images of a glTF file: specification sections 3.8 and 3.9.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "engine/scene/gltf_document.h"
#include "engine/scene/gltf_loader.h"

namespace macula::scene::gltf {

/// Decodes images one by one within the limits.
class ImageDecoder {
 public:
  ImageDecoder(Document& document, const GltfLimits& limits)
      : document_(document), limits_(limits) {}

  /// Image `index` of the file as 8-bit RGBA (of 16 bits the upper 8); nothing, and a warning,
  /// where it is missing, neither PNG nor JPEG, damaged or beyond the limits.
  [[nodiscard]] std::optional<Image> decode(std::size_t index);

 private:
  Document& document_;
  const GltfLimits& limits_;
  std::uint64_t bytes_ = 0;  // decoded so far
};

/// Fills scene.materials and scene.images, both in the order of the file; decodes the images that
/// the materials read.
/// @throws InputError on a texture, sampler or image index that leads nowhere
void readMaterials(Document& document, const GltfLimits& limits, Scene& scene);

}  // namespace macula::scene::gltf
