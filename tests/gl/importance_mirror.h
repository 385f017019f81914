// Importance and k on the CPU: plain, in double and 64-bit integers, without the shaders' code.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace macula::test {

struct MirrorSettings {
  double rangeBias = 0.35;
  double periphery = 3.0;
  double layerLimit = 10.0;
  double widened = 0.0;  ///< pixels around o that count as looked at
};

/// I_per I_d of Vasilakis 2017, Eq. 3 and 4 (no Fresnel history, no noise), clamped.
/// @param p pixel centre · @param o point of interest, both in pixels
double importanceOf(glm::dvec2 p, glm::dvec2 o, glm::dvec2 size, double layers,
                    const MirrorSettings& settings);

/// k of every pixel: floor(I (M - Z) / sum I), at least 1, where Z counts the pixels whose share of
/// M - C rounds to 0 and C the covered ones; needs M >= C.
std::vector<std::uint32_t> layersOf(const std::vector<std::uint32_t>& importance,
                                    const std::vector<std::uint32_t>& counts, std::uint64_t slots);

}  // namespace macula::test
