#include "engine/scene/opacity_override.h"

#include <algorithm>
#include <map>

namespace macula::scene {
namespace {

constexpr std::uint8_t kSolid = 255;
constexpr std::size_t kAlpha = 3;  // byte of a pixel
constexpr std::size_t kPixelBytes = 4;

bool isSolid(const Image& image) {
  for (std::size_t i = kAlpha; i < image.rgba.size(); i += kPixelBytes) {
    if (image.rgba[i] != kSolid) return false;
  }
  return true;
}

/// Images as an OPAQUE material sees them: without alpha. Others may use the same image with it.
class SolidImages {
 public:
  explicit SolidImages(Scene& scene) : scene_(scene) {}

  /// The image itself where it has no alpha, else a copy without; kNone stays.
  std::int32_t of(std::int32_t image) {
    if (image == kNone) return kNone;
    const auto [found, isNew] = copies_.try_emplace(image, image);
    if (isNew && !isSolid(scene_.images[static_cast<std::size_t>(image)])) {
      Image copy = scene_.images[static_cast<std::size_t>(image)];
      for (std::size_t i = kAlpha; i < copy.rgba.size(); i += kPixelBytes) copy.rgba[i] = kSolid;
      found->second = static_cast<std::int32_t>(scene_.images.size());
      scene_.images.push_back(std::move(copy));
    }
    return found->second;
  }

 private:
  Scene& scene_;
  std::map<std::int32_t, std::int32_t> copies_;
};

/// Gives surfaces without a material glTF's default one, so that it can be changed.
void nameDefaultMaterial(Scene& scene) {
  const auto unnamed = [](const Primitive& primitive) { return primitive.material == kNone; };
  if (std::none_of(scene.primitives.begin(), scene.primitives.end(), unnamed)) return;
  const auto added = static_cast<std::int32_t>(scene.materials.size());
  scene.materials.emplace_back();
  for (Primitive& primitive : scene.primitives) {
    if (unnamed(primitive)) primitive.material = added;
  }
}

}  // namespace

void overrideOpacity(Scene& scene, float opacity) {
  if (opacity >= 1.0F) return;
  nameDefaultMaterial(scene);
  for (Primitive& primitive : scene.primitives) {
    if (scene.materialOf(primitive).alphaMode != AlphaMode::Opaque) continue;
    for (VertexAttributes& vertex : primitive.attributes) vertex.color.a = 1.0F;
  }
  SolidImages solid(scene);
  for (Material& material : scene.materials) {
    if (material.alphaMode == AlphaMode::Opaque) {
      material.baseColor.a = 1.0F;
      material.baseColorTexture.image = solid.of(material.baseColorTexture.image);
    }
    material.alphaMode = AlphaMode::Blend;
    material.baseColor.a *= opacity;
  }
}

}  // namespace macula::scene
