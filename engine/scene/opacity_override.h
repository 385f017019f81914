// Opaque models looked at as transparent ones.
#pragma once

#include "engine/scene/scene.h"

namespace macula::scene {

/// Draws every material as transparent (glTF's BLEND), with its alpha multiplied by `opacity`.
/// Alpha that glTF 2.0, section 3.9.4, says to ignore stays ignored: a material that was OPAQUE
/// gets `opacity` everywhere, whatever its texture and its vertices hold. One that was MASK keeps
/// the texture's alpha, without the cut-off. Surfaces without a material get one. Comes before
/// overrideLighting(), so that it finds them transparent.
/// @param opacity above 0, up to 1; 1 leaves the scene exactly as it is
void overrideOpacity(Scene& scene, float opacity);

}  // namespace macula::scene
