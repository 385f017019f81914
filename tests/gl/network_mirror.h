// What networks of importance see, on the CPU: plain, in double, from fragments that were all
// stored and sorted, without the shaders' code.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "gl_fixture.h"
#include "shared/network.h"

namespace macula::test {

struct MirrorFragment {
  double distance = 0.0;  ///< along the view axis, metres
  glm::dvec4 color{0.0};  ///< premultiplied linear RGBA
};

/// The fragments of a frame and what lies behind them. Rows from the top.
struct MirrorFrame {
  glm::ivec2 size{0};
  double farPlane = 1.0;                            ///< metres
  std::vector<std::vector<MirrorFragment>> pixels;  ///< each nearest first
  std::vector<glm::dvec3> behind;                   ///< opaque linear RGB
};

/// @param exact drew the frame with ab-sbuffer · @param opaque drew it without transparency
[[nodiscard]] MirrorFrame frameOf(const Bench& exact, const Bench& opaque);

/// The twelve features of Tsopouridis 2021, section 4.2, of every pixel, 0 where it is not covered.
/// @param slots of the budget
[[nodiscard]] std::vector<std::array<double, 12>> thesisFeatures(const MirrorFrame& frame,
                                                                 std::uint64_t slots);

/// What the slices of a pixel hold.
struct MirrorSlice {
  double fragments = 0.0;
  double tau = 0.0;  ///< optical depth, halvings
  glm::dvec3 tauColor{0.0};
};

struct MirrorSlices {
  std::array<MirrorSlice, LEARNED_SLICES> slices;
  double nearestBoundary = 1.0;  ///< how close a fragment is to another slice, in slices
};

/// @param fixedPoint sums in steps of 1/1024, as the shader does
[[nodiscard]] MirrorSlices slicesOf(const std::vector<MirrorFragment>& fragments, bool fixedPoint);

// Where a group of Macula's features begins; the number of fragments and the errors stand before.
inline constexpr std::size_t kPasses = 1 + LEARNED_SLICES;
inline constexpr std::size_t kShares = kPasses + LEARNED_SLICES;
inline constexpr std::size_t kThickness = kShares + LEARNED_SLICES;
inline constexpr std::size_t kColors = kThickness + LEARNED_SLICES;
inline constexpr std::size_t kBehind = kColors + 3 * LEARNED_SLICES;

/// The features of Macula's own network of a covered pixel, before logarithms and square roots:
/// squared errors, optical depths and colours as they are.
[[nodiscard]] std::array<double, LEARNED_FEATURES> plainLearnedFeatures(const MirrorSlices& slices,
                                                                        glm::dvec3 behind);

/// The features that a shader computed, made plain in the same way. @param first of them
[[nodiscard]] std::array<double, LEARNED_FEATURES> plainOf(const float* first);

/// An output of a network between the middles of tiles, as lib/network_output.glsl says.
/// @param covered share of each tile that is covered · @param tiles wide and high
[[nodiscard]] double outputBetween(const std::vector<double>& values,
                                   const std::vector<double>& covered, glm::ivec2 tiles, int tile,
                                   glm::ivec2 pixel);

}  // namespace macula::test
