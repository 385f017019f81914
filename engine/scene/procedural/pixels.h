// Tools for images computed in code: lattice noise and a loop over pixels. Integers and exact float
// arithmetic only, so that the bytes are the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <utility>

#include "engine/scene/scene.h"

namespace macula::scene {

/// A hash of a lattice point to [0, 1): the finaliser of MurmurHash3 (Appleby 2011).
[[nodiscard]] inline float latticeValue(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  std::uint32_t h = x * 0x9E3779B1U ^ y * 0x85EBCA77U ^ seed * 0xC2B2AE3DU;
  h = (h ^ (h >> 16U)) * 0x85EBCA6BU;
  h = (h ^ (h >> 13U)) * 0xC2B2AE35U;
  return static_cast<float>((h ^ (h >> 16U)) >> 8U) * 0x1p-24F;
}

/// Value noise in 0..1 over a lattice of `cells` x `cells` that repeats in the unit square.
[[nodiscard]] inline float noise(float u, float v, std::uint32_t cells, std::uint32_t seed) {
  const float x = u * static_cast<float>(cells);
  const float y = v * static_cast<float>(cells);
  const auto x0 = static_cast<std::uint32_t>(x);
  const auto y0 = static_cast<std::uint32_t>(y);
  const auto smooth = [](float t) { return t * t * (3.0F - 2.0F * t); };
  const float tx = smooth(x - static_cast<float>(x0));
  const float ty = smooth(y - static_cast<float>(y0));
  const auto value = [&](std::uint32_t i, std::uint32_t j) {
    return latticeValue((x0 + i) % cells, (y0 + j) % cells, seed);
  };
  return glm::mix(glm::mix(value(0, 0), value(1, 0), tx), glm::mix(value(0, 1), value(1, 1), tx),
                  ty);
}

/// Four octaves of noise, 0..1.
[[nodiscard]] inline float fractal(float u, float v, std::uint32_t cells, std::uint32_t seed) {
  float sum = 0.0F;
  float weight = 0.5F;
  for (std::uint32_t octave = 0; octave < 4; ++octave) {
    sum += weight * noise(u, v, cells << octave, seed + octave);
    weight *= 0.5F;
  }
  return sum / 0.9375F;  // the weights' sum
}

/// 0..1..0 over each unit of x.
[[nodiscard]] inline float triangleWave(float x) {
  const float t = x - std::floor(x);
  return t < 0.5F ? 2.0F * t : 2.0F - 2.0F * t;
}

/// Fills an image from a function of the pixel centre (u, v in 0..1 from the top left).
template <typename Shade>
[[nodiscard]] Image drawImage(std::string name, int width, int height, const Shade& shade) {
  Image image;
  image.name = std::move(name);
  image.width = width;
  image.height = height;
  image.rgba.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(width);
      const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(height);
      const glm::vec4 color = glm::clamp(shade(u, v), 0.0F, 1.0F);
      for (int c = 0; c < 4; ++c) {
        image.rgba.push_back(static_cast<std::uint8_t>(color[c] * 255.0F + 0.5F));
      }
    }
  }
  return image;
}

/// 32 bits of a seed for latticeValue.
[[nodiscard]] inline std::uint32_t foldSeed(std::uint64_t seed) {
  return static_cast<std::uint32_t>(seed ^ seed >> 32U);
}

}  // namespace macula::scene
