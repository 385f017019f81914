#include "engine/scene/procedural/textures.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "engine/core/random.h"
#include "engine/scene/procedural/pixels.h"

namespace macula::scene {

Image marbleTiles(int size, std::uint64_t seed) {
  const std::uint32_t key = foldSeed(seed);
  return drawImage("marble tiles", size, size, [key](float u, float v) {
    const bool dark = (u < 0.5F) != (v < 0.5F);
    const float edge =
        std::min(std::min(triangleWave(u * 2.0F), triangleWave(v * 2.0F)), 0.02F) / 0.02F;
    const float cloud = fractal(u, v, 4, key);
    const float ridge = 1.0F - std::abs(2.0F * fractal(u, v, 3, key + 17) - 1.0F);
    const float vein = ridge * ridge * ridge * ridge * ridge * ridge * ridge * ridge;
    const glm::vec3 light =
        glm::mix(glm::vec3(0.83F, 0.80F, 0.75F), glm::vec3(0.94F, 0.92F, 0.88F), cloud) -
        0.16F * vein;
    const glm::vec3 deep =
        glm::mix(glm::vec3(0.24F, 0.27F, 0.29F), glm::vec3(0.36F, 0.39F, 0.41F), cloud) +
        0.20F * vein;
    return glm::vec4((dark ? deep : light) * glm::mix(0.6F, 1.0F, edge), 1.0F);
  });
}

Image woodBoards(int size, std::uint64_t seed) {
  constexpr int kBoards = 4;
  const std::uint32_t key = foldSeed(seed) + 101;
  return drawImage("wood", size, size, [key](float u, float v) {
    const auto board = static_cast<std::uint32_t>(u * kBoards);
    const float tone = latticeValue(board, 0, key);
    // Stretched along the board: the grain varies sixteen times faster across it.
    const float bend = 0.12F * noise(u, v, 4, key + board);
    const float grain = triangleWave((u + bend) * 24.0F) * 0.5F + 0.5F * noise(u, v, 32, key + 9);
    const glm::vec3 color = glm::mix(glm::vec3(0.36F, 0.21F, 0.11F), glm::vec3(0.60F, 0.39F, 0.22F),
                                     0.35F * tone + 0.65F * grain);
    const float edge = std::min(triangleWave(u * kBoards), 0.06F) / 0.06F;
    return glm::vec4(color * glm::mix(0.55F, 1.0F, edge), 1.0F);
  });
}

Image plaster(int size, std::uint64_t seed) {
  const std::uint32_t key = foldSeed(seed) + 211;
  return drawImage("plaster", size, size, [key](float u, float v) {
    const float mottle = fractal(u, v, 8, key);
    return glm::vec4(glm::vec3(0.82F, 0.77F, 0.70F) + 0.08F * mottle, 1.0F);
  });
}

Image frond(int size, std::uint64_t seed) {
  const std::uint32_t key = foldSeed(seed) + 307;
  return drawImage("frond", size, size, [key](float u, float v) {
    const float along = 1.0F - v;  // 0 at the stem, 1 at the tip
    const float side = std::abs(2.0F * u - 1.0F);
    // Leaflets lean towards the tip; the outline is widest at a third of the length.
    const float outline =
        along < 0.33F ? 0.35F + 1.9F * along : 0.98F * (1.0F - along) / 0.67F + 0.02F;
    const float leaflet = triangleWave((along - 0.16F * side) * 15.0F);
    const float width = 0.75F * (1.0F - 0.75F * side / std::max(outline, 0.01F));
    const bool stem = side < 0.035F && along < 0.97F;
    const bool leaf = side < outline && leaflet < width && along > 0.05F;
    const float shade = 0.25F * noise(u, v, 16, key) + 0.25F * leaflet;
    const glm::vec3 green =
        glm::mix(glm::vec3(0.16F, 0.36F, 0.13F), glm::vec3(0.46F, 0.64F, 0.24F), shade);
    return glm::vec4(stem ? glm::vec3(0.45F, 0.52F, 0.25F) : green, stem || leaf ? 1.0F : 0.0F);
  });
}

Image painting(int size, std::uint64_t seed) {
  Random random(seed, 5);
  // Warm and cool grounds in turn, bands that darken towards the bottom, one disc.
  const glm::vec3 warm{random.range(0.75F, 0.95F), random.range(0.45F, 0.65F),
                       random.range(0.2F, 0.35F)};
  const glm::vec3 cool{random.range(0.1F, 0.25F), random.range(0.3F, 0.45F),
                       random.range(0.45F, 0.65F)};
  const glm::vec2 disc{random.range(0.25F, 0.75F), random.range(0.2F, 0.45F)};
  const float discRadius = random.range(0.08F, 0.17F);
  const float horizon = random.range(0.45F, 0.65F);
  const std::uint32_t key = random.next();
  return drawImage("painting", size, size, [=](float u, float v) {
    const float brush = 0.12F * (fractal(u, v, 8, key) - 0.5F);
    const float sky = std::min(v / horizon, 1.0F);
    glm::vec3 color = glm::mix(cool, warm, sky) + brush;
    const glm::vec2 fromDisc = glm::vec2(u, v) - disc;
    if (glm::dot(fromDisc, fromDisc) < discRadius * discRadius) {
      color = glm::vec3(0.98F, 0.88F, 0.62F) + brush;
    }
    for (std::uint32_t ridge = 0; ridge < 4; ++ridge) {
      const float step = static_cast<float>(ridge);
      const float line =
          horizon + 0.13F * step + 0.16F * (noise(u, 0.0F, 3 + ridge, key + ridge) - 0.5F);
      if (v > line)
        color = glm::mix(cool * 0.9F, glm::vec3(0.09F, 0.08F, 0.12F), 0.28F * step) + brush;
    }
    return glm::vec4(color, 1.0F);
  });
}

Image carpet(int width, int height, std::uint64_t seed) {
  const std::uint32_t key = foldSeed(seed) + 401;
  const float aspect = static_cast<float>(height) / static_cast<float>(width);
  return drawImage("carpet", width, height, [=](float u, float v) {
    const float x = std::min(u, 1.0F - u);
    const float y = std::min(v, 1.0F - v) * aspect;
    const float border = std::min(x, y);
    const float lozenge = triangleWave(u * 3.0F) + triangleWave(v * aspect * 3.0F);
    glm::vec3 color = std::abs(lozenge - 1.0F) < 0.12F    ? glm::vec3(0.78F, 0.62F, 0.36F)
                      : lozenge > 1.45F || lozenge < 0.5F ? glm::vec3(0.16F, 0.22F, 0.36F)
                                                          : glm::vec3(0.47F, 0.12F, 0.12F);
    if (border < 0.14F) color = glm::vec3(0.14F, 0.18F, 0.30F);
    if (border < 0.11F && border > 0.04F && triangleWave((u + v * aspect) * 9.0F) > 0.5F) {
      color = glm::vec3(0.74F, 0.58F, 0.34F);
    }
    if (border < 0.02F) color = glm::vec3(0.70F, 0.56F, 0.34F);
    return glm::vec4(color * (0.88F + 0.24F * noise(u, v, 64, key)), 1.0F);
  });
}

}  // namespace macula::scene
