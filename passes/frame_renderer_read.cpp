// FrameRenderer: images of the last frame.
#include <algorithm>

#include "passes/frame_renderer.h"
#include "passes/resources.h"

namespace macula::passes {
namespace {

/// Red, green and blue of a texture, rows from the top.
template <typename T>
void readRgb(const frame::FrameResources& resources, const frame::Resource& texture, GLenum type,
             std::vector<T>& rgb) {
  const gl::Texture& t = resources.texture(texture);
  const auto row = static_cast<std::ptrdiff_t>(t.width()) * 3;
  rgb.resize(static_cast<std::size_t>(row) * static_cast<std::size_t>(t.height()));
  resources.read(texture, GL_RGB, type, rgb.size() * sizeof(T), rgb.data());
  // GL counts rows from the bottom.
  for (std::ptrdiff_t y = 0; y < t.height() / 2; ++y) {
    const auto mirrored = t.height() - 1 - y;
    std::swap_ranges(rgb.begin() + y * row, rgb.begin() + (y + 1) * row,
                     rgb.begin() + mirrored * row);
  }
}

const frame::Resource& shownIn(const frame::FrameResources& resources) {
  return resources.has(kHeatmapColor) ? kHeatmapColor : kDisplayColor;
}

}  // namespace

void FrameRenderer::readDisplay(std::vector<std::uint8_t>& rgb) const {
  readRgb(resources_, kDisplayColor, GL_UNSIGNED_BYTE, rgb);
}

void FrameRenderer::readShown(std::vector<std::uint8_t>& rgb) const {
  readRgb(resources_, shownIn(resources_), GL_UNSIGNED_BYTE, rgb);
}

void FrameRenderer::readLinear(std::vector<float>& rgb) const {
  readRgb(resources_, kLinearColor, GL_FLOAT, rgb);
}

const gl::Texture& FrameRenderer::shownTexture() const {
  return resources_.textureFor(shownIn(resources_),
                               GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

std::optional<image::Legend> FrameRenderer::legend() const {
  if (!resources_.has(kHeatmapColor)) return std::nullopt;
  return legendOf(settings_.heatmap, heatmapRange_);
}

}  // namespace macula::passes
