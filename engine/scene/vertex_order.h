// Triangles and vertices in the order in which a GPU draws them fastest.
#pragma once

#include "engine/scene/scene.h"

namespace macula::scene {

/// The same triangles, ordered so that neighbours follow each other and hide others early, and the
/// vertices in the order of their first use; those without a use are left out (meshoptimizer).
/// Where triangles coincide in depth, the order decides which is seen.
[[nodiscard]] Primitive orderedForDrawing(const Primitive& primitive);

}  // namespace macula::scene
