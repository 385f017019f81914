#include "engine/scene/alpha_holes.h"

#include <algorithm>
#include <optional>

#include "shared/scene_data.h"

namespace macula::scene {
namespace {

constexpr float kLeastAlpha = static_cast<float>(LEAST_ALPHA);

/// Least and greatest alpha.
struct Range {
  float least = 1.0F;
  float most = 1.0F;
  [[nodiscard]] Range times(const Range& other) const {
    return {least * other.least, most * other.most};
  }
};

/// Of all texels; what is filtered from them, in mip levels too, lies between.
Range rangeOf(const Image& image) {
  constexpr std::size_t kAlpha = 3;  // byte of a texel
  constexpr std::size_t kTexelBytes = 4;
  std::uint8_t least = 255;
  std::uint8_t most = 0;
  for (std::size_t i = kAlpha; i < image.rgba.size(); i += kTexelBytes) {
    least = std::min(least, image.rgba[i]);
    most = std::max(most, image.rgba[i]);
    if (least == 0 && most == 255) break;
  }
  return {static_cast<float>(least) / 255.0F, static_cast<float>(most) / 255.0F};
}

Range rangeOf(const Primitive& primitive) {
  if (primitive.attributes.empty()) return {};
  Range range{primitive.attributes.front().color.a, 0.0F};
  for (const VertexAttributes& vertex : primitive.attributes) {
    range.least = std::max(0.0F, std::min(range.least, vertex.color.a));
    range.most = std::max(range.most, vertex.color.a);
  }
  return range;
}

/// @param texture of the base colour
AlphaHoles holesOf(const Material& material, const Range& texture, const Range& vertices) {
  const float factor = std::max(0.0F, material.baseColor.a);
  const Range surface = texture.times({factor, factor});
  const Range whole = surface.times(vertices);
  switch (material.alphaMode) {
    case AlphaMode::Opaque:
      return AlphaHoles::None;
    case AlphaMode::Mask:
      if (whole.most < material.alphaCutoff) return AlphaHoles::All;
      return whole.least < material.alphaCutoff ? AlphaHoles::Some : AlphaHoles::None;
    case AlphaMode::Blend:
      if (whole.most <= kLeastAlpha) return AlphaHoles::All;
      return surface.least <= kLeastAlpha ? AlphaHoles::Some : AlphaHoles::None;
  }
  return AlphaHoles::Some;
}

}  // namespace

std::vector<AlphaHoles> alphaHolesOf(const Scene& scene) {
  std::vector<std::optional<Range>> images(scene.images.size());
  const auto textureRange = [&](std::int32_t image) {
    if (image == kNone) return Range{};
    std::optional<Range>& range = images[static_cast<std::size_t>(image)];
    if (!range) range = rangeOf(scene.images[static_cast<std::size_t>(image)]);
    return *range;
  };
  std::vector<AlphaHoles> holes;
  holes.reserve(scene.primitives.size());
  for (const Primitive& primitive : scene.primitives) {
    const Material& material = scene.materialOf(primitive);
    holes.push_back(
        material.isTransparent() && material.alphaMode != AlphaMode::Opaque
            ? holesOf(material, textureRange(material.baseColorTexture.image), rangeOf(primitive))
            : AlphaHoles::None);
  }
  return holes;
}

bool isNothing(const Material& material, const Primitive& primitive, const std::uint32_t* corners) {
  return material.alphaMode == AlphaMode::Blend &&
         std::all_of(corners, corners + 3, [&](std::uint32_t corner) {
           return material.baseColor.a * primitive.attributes[corner].color.a <= kLeastAlpha;
         });
}

}  // namespace macula::scene
