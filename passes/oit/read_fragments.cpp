#include "passes/oit/read_fragments.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>
#include <stdexcept>

#include "engine/gl/gl.h"

namespace macula::passes {

using frame::Resource;

namespace {

/// Level 0 of a texture, rows from the bottom as GL has them.
template <typename T>
std::vector<T> readTexture(const frame::FrameResources& resources, Resource resource, GLenum format,
                           GLenum type) {
  const gl::Texture& texture = resources.texture(resource);
  std::vector<T> texels(static_cast<std::size_t>(texture.width()) *
                        static_cast<std::size_t>(texture.height()));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  glGetTextureImage(texture.id(), 0, format, type, static_cast<GLsizei>(texels.size() * sizeof(T)),
                    texels.data());
  return texels;
}

std::vector<glm::uvec2> readBuffer(const frame::FrameResources& resources, Resource resource) {
  const gl::Buffer& buffer = resources.buffer(resource);
  std::vector<glm::uvec2> values(buffer.bytes() / sizeof(glm::uvec2));
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  buffer.download(values.data(), values.size() * sizeof(glm::uvec2));
  return values;
}

/// The key puts the nearest first: see shaders/lib/oit.glsl.
bool isNearer(const glm::uvec2& a, const glm::uvec2& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

glm::vec4 unpackColor(const glm::uvec2& color) {
  return {glm::unpackHalf2x16(color.x), glm::unpackHalf2x16(color.y)};
}

}  // namespace

measure::FragmentImage readFragments(const FrameRenderer& exact, const FrameRenderer& opaque) {
  const frame::FrameResources& resources = exact.resources();
  const gl::Texture& background = opaque.resources().texture(Resource::HdrColor);
  measure::FragmentImage image;
  image.width = background.width();
  image.height = background.height();
  const bool stored = resources.has(Resource::FragmentKeys);
  // Without a transparent surface in the scene nothing was allocated.
  if (stored && (exact.plan().method->id != "ab-sbuffer" || exact.plan().resized() ||
                 resources.texture(Resource::FragmentRange).width() != image.width ||
                 resources.texture(Resource::FragmentRange).height() != image.height)) {
    throw std::invalid_argument("fragments are read from a frame by ab-sbuffer, of one size");
  }
  const auto width = static_cast<std::size_t>(image.width);
  const auto height = static_cast<std::size_t>(image.height);
  const auto behind =
      readTexture<glm::vec3>(opaque.resources(), Resource::HdrColor, GL_RGB, GL_FLOAT);
  std::vector<glm::uvec2> ranges(width * height, glm::uvec2(0));
  std::vector<std::uint32_t> fill(width * height, 0);
  std::vector<glm::uvec2> keys;
  std::vector<glm::uvec2> colors;
  if (stored) {
    ranges =
        readTexture<glm::uvec2>(resources, Resource::FragmentRange, GL_RG_INTEGER, GL_UNSIGNED_INT);
    fill = readTexture<std::uint32_t>(resources, Resource::FragmentFill, GL_RED_INTEGER,
                                      GL_UNSIGNED_INT);
    keys = readBuffer(resources, Resource::FragmentKeys);
    colors = readBuffer(resources, Resource::FragmentColors);
  }
  image.offsets.reserve(width * height + 1);
  image.offsets.push_back(0);
  image.behind.reserve(width * height);
  std::vector<std::size_t> slots;
  for (std::size_t row = height; row-- > 0;) {  // from the top
    for (std::size_t texel = row * width; texel < (row + 1) * width; ++texel) {
      const std::size_t first = ranges[texel].x;
      const std::size_t count = std::min(fill[texel], ranges[texel].y);
      if (count > 0 && first + count > std::min(keys.size(), colors.size())) {
        throw std::invalid_argument("fragments are read from a frame that is exact");
      }
      slots.resize(count);
      for (std::size_t i = 0; i < count; ++i) slots[i] = first + i;
      std::sort(slots.begin(), slots.end(),
                [&](std::size_t a, std::size_t b) { return isNearer(keys[a], keys[b]); });
      for (const std::size_t slot : slots) image.fragments.push_back(unpackColor(colors[slot]));
      image.offsets.push_back(image.fragments.size());
      image.behind.push_back(behind[texel]);
    }
  }
  return image;
}

}  // namespace macula::passes
