// Transparent surfaces that are known before drawing to have invisible fragments. A fragment whose
// alpha is LEAST_ALPHA (shared/scene_data.h) or less is neither counted nor stored, and takes no
// part in any decision for a pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene {

/// Where material, texture or cut-off make fragments of a primitive invisible. A corner whose alpha
/// is 0 makes no hole by itself: between it and the others alpha is above 0, and triangles with
/// three such corners are not drawn (isNothing()).
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
