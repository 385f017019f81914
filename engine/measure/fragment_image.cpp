#include "engine/measure/fragment_image.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/measure/srgb.h"

namespace macula::measure {
namespace {

/// tau of the class comment; alpha is clamped to 0..1.
float opticalDepth(float alpha) {
  const float passed = 1.0F - std::clamp(alpha, 0.0F, 1.0F);
  return passed > 0.0F ? std::min(-std::log2(passed), kMaxOpticalDepth) : kMaxOpticalDepth;
}

}  // namespace

std::uint64_t FragmentImage::coveredPixels() const {
  std::uint64_t covered = 0;
  for (std::size_t pixel = 0; pixel < pixels(); ++pixel) covered += depth(pixel) > 0 ? 1U : 0U;
  return covered;
}

void requireConsistent(const FragmentImage& image) {
  const bool sides = image.width >= 1 && image.height >= 1;
  const std::size_t pixels =
      sides ? static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) : 0;
  if (!sides || image.behind.size() != pixels || image.offsets.size() != pixels + 1 ||
      image.offsets.front() != 0 || image.offsets.back() != image.fragments.size() ||
      !std::is_sorted(image.offsets.begin(), image.offsets.end())) {
    throw std::invalid_argument("a fragment image whose sides, offsets and arrays do not agree");
  }
}

void LayerSweep::sumRests(std::span<const glm::vec4> layers) {
  rests_.assign(layers.size() + 1, Rest{});
  for (std::size_t i = layers.size(); i-- > 0;) {
    const glm::vec4& layer = layers[i];
    Rest rest = rests_[i + 1];
    rest.transmittance *= 1.0F - layer.a;
    if (layer.a > 0.0F) {
      const float tau = opticalDepth(layer.a);
      rest.weighted += tau * (glm::vec3(layer) / layer.a);
      rest.opticalDepth += tau;
    }
    rests_[i] = rest;
  }
}

std::span<const glm::vec3> LayerSweep::colours(const FragmentImage& image, std::size_t pixel) {
  const std::span<const glm::vec4> layers = image.layers(pixel);
  const glm::vec3 behind = image.behind[pixel];
  if (tail_ == Tail::Mean) sumRests(layers);
  colours_.assign(1, behind);
  glm::vec3 colour(0.0F);
  float transmittance = 1.0F;
  for (std::size_t k = 1; k <= layers.size(); ++k) {
    if (tail_ == Tail::Mean && k < layers.size()) {
      // k - 1 layers stand in `colour`; the others share the last slot.
      const Rest& rest = rests_[k - 1];
      const glm::vec3 mean =
          rest.opticalDepth > 0.0F ? rest.weighted / rest.opticalDepth : glm::vec3(0.0F);
      colours_.push_back(colour + transmittance * ((1.0F - rest.transmittance) * mean +
                                                   rest.transmittance * behind));
    }
    colour += transmittance * glm::vec3(layers[k - 1]);
    transmittance *= 1.0F - layers[k - 1].a;
    if (tail_ == Tail::None || k == layers.size()) {
      colours_.push_back(colour + transmittance * behind);
    }
  }
  return colours_;
}

glm::vec3 composite(const FragmentImage& image, std::size_t pixel, std::uint32_t k, Tail tail) {
  LayerSweep sweep(tail);
  return sweep.colours(image, pixel)[std::min(k, image.depth(pixel))];
}

glm::vec3 displayColour(const glm::vec3& linear) {
  const auto encode = [](float value) { return encodeSrgb(std::clamp(value, 0.0F, 1.0F)); };
  return {encode(linear.r), encode(linear.g), encode(linear.b)};
}

}  // namespace macula::measure
