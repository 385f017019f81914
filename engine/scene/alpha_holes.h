// Which fragments of transparent surfaces are there at all, as far as it is known before drawing.
// One whose alpha is LEAST_ALPHA (shared/scene_data.h) or less adds nothing: it is neither counted
// nor stored, and takes no part in anything that is decided for a pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene {

/// Where fragments of a primitive add nothing by material, texture or cut-off. Corners whose alpha
/// is 0 make no hole of their own: between them and others alpha is above 0, and triangles of
/// nothing else are not drawn (isNothing()).
enum class AlphaHoles : std::uint8_t {
  None,  ///< nowhere: there is nothing to test
  Some,  ///< to be tested at each fragment
  All,   ///< everywhere: not to be drawn
};

/// One entry a primitive of the scene; None for those that are not transparent.
[[nodiscard]] std::vector<AlphaHoles> alphaHolesOf(const Scene& scene);

/// Whether a triangle of a blended material adds nothing, because all of its corners' alphas are 0.
/// @param corners three indices of vertices
[[nodiscard]] bool isNothing(const Material& material, const Primitive& primitive,
                             const std::uint32_t* corners);

}  // namespace macula::scene
