// All fragments of an image, and what a pixel shows when only some of its layers are kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace macula::measure {

/// Every transparent fragment of a frame, and the opaque image behind them. Rows from the top.
struct FragmentImage {
  int width = 0;
  int height = 0;
  /// Fragments of pixel p: [offsets[p], offsets[p + 1]); width * height + 1 entries.
  std::vector<std::uint64_t> offsets;
  std::vector<glm::vec4> fragments;  ///< premultiplied linear RGBA, nearest first in each pixel
  std::vector<glm::vec3> behind;     ///< opaque linear RGB of each pixel

  [[nodiscard]] std::size_t pixels() const { return behind.size(); }
  /// Nearest first.
  [[nodiscard]] std::span<const glm::vec4> layers(std::size_t pixel) const {
    return std::span(fragments).subspan(offsets[pixel], offsets[pixel + 1] - offsets[pixel]);
  }
  /// Number of fragments of a pixel.
  [[nodiscard]] std::uint32_t depth(std::size_t pixel) const {
    return static_cast<std::uint32_t>(offsets[pixel + 1] - offsets[pixel]);
  }
  [[nodiscard]] std::uint64_t coveredPixels() const;
};

/// @throws std::invalid_argument where sides, offsets and arrays do not agree
void requireConsistent(const FragmentImage& image);

/// What becomes of the layers that are left out.
enum class Tail : std::uint8_t {
  None,  ///< they are lost
  /// One layer behind those that are kept: the mean of their colours (not premultiplied) weighted
  /// by optical depth tau = -log2(1 - alpha), at most kMaxOpticalDepth, over their exact total
  /// transmittance. It takes one of the pixel's slots: k slots hold k - 1 layers and the tail where
  /// the pixel has more than k, and all layers where it has k or fewer.
  Mean,
};

/// An opaque layer's optical depth is infinite; 16 halvings leave less than an 8-bit step.
inline constexpr float kMaxOpticalDepth = 16.0F;

/// Linear RGB of every number of slots of a pixel, 0 (the opaque image) to its depth (the exact
/// colour). Layers are composited front to back, over (Porter & Duff 1984). One object serves many
/// pixels and keeps its memory, O(deepest pixel).
class LayerSweep {
 public:
  explicit LayerSweep(Tail tail) : tail_(tail) {}
  /// @returns depth(pixel) + 1 colours, valid until the next call
  [[nodiscard]] std::span<const glm::vec3> colours(const FragmentImage& image, std::size_t pixel);

 private:
  /// What the layers from one on come to.
  struct Rest {
    glm::vec3 weighted{0.0F};  ///< sum of tau times colour
    float opticalDepth = 0.0F;
    float transmittance = 1.0F;
  };
  void sumRests(std::span<const glm::vec4> layers);

  Tail tail_;
  std::vector<glm::vec3> colours_;
  std::vector<Rest> rests_;
};

/// Linear RGB of one pixel with k slots; k beyond its depth counts as its depth.
[[nodiscard]] glm::vec3 composite(const FragmentImage& image, std::size_t pixel, std::uint32_t k,
                                  Tail tail);

/// From linear RGB to what is compared.
using DisplayTransform = std::function<glm::vec3(const glm::vec3&)>;

/// Clamps to 0..1 and encodes as sRGB, as toDisplay() does.
[[nodiscard]] glm::vec3 displayColour(const glm::vec3& linear);

}  // namespace macula::measure
