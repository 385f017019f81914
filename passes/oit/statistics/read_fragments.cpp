#include "passes/oit/statistics/read_fragments.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>
#include <stdexcept>

#include "passes/resources.h"

namespace macula::passes {
namespace {

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
  const gl::Texture& background = opaque.resources().texture(kHdrColor);
  measure::FragmentImage image;
  image.width = background.width();
  image.height = background.height();
  const bool stored = resources.has(kFragmentKeys);
  // Without a transparent surface in the scene nothing was allocated.
  const bool whole = exact.plan().method->exact && exact.plan().method->hasRanges();
  if (stored && (!whole || exact.plan().reduced() ||
                 resources.texture(kFragmentRange).width() != image.width ||
                 resources.texture(kFragmentRange).height() != image.height)) {
    throw std::invalid_argument("fragments are read from a frame by ab-sbuffer, of one size");
  }
  const auto width = static_cast<std::size_t>(image.width);
  const auto height = static_cast<std::size_t>(image.height);
  const auto behind = opaque.resources().readTexture<glm::vec3>(kHdrColor, GL_RGB, GL_FLOAT);
  std::vector<glm::uvec2> ranges(width * height, glm::uvec2(0));
  std::vector<std::uint32_t> fill(width * height, 0);
  std::vector<glm::uvec2> keys;
  std::vector<glm::uvec2> colors;
  if (stored) {
    ranges = resources.readTexture<glm::uvec2>(kFragmentRange, GL_RG_INTEGER, GL_UNSIGNED_INT);
    fill = resources.readTexture<std::uint32_t>(kFragmentFill, GL_RED_INTEGER, GL_UNSIGNED_INT);
    keys = resources.readBuffer<glm::uvec2>(kFragmentKeys);
    colors = resources.readBuffer<glm::uvec2>(kFragmentColors);
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
