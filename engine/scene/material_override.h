// The same geometry with other materials, so that lighting and transparency can be measured on it.
#pragma once

#include <cstdint>

#include "engine/scene/scene.h"

namespace macula::scene {

enum class LightingOverride : std::uint8_t {
  Own,    ///< as the scene says
  Unlit,  ///< transparent materials show their colour; opaque ones stay as they are
  Four,   ///< transparent materials are lit, and by four fixed lights
};

/// Changes the transparent materials, and under `Four` also the lights and the ambient term of the
/// whole scene: a sun that casts shadows, two point lights and a spot, placed and scaled by
/// boundsOf(scene), so that scenes of every size are equally bright. A material that was unlit
/// becomes a rough dielectric, as KHR_materials_unlit recommends for renderers that must light it.
/// Call it before addDefaultLights().
void overrideLighting(Scene& scene, LightingOverride lighting);

/// Draws every material as transparent (glTF's BLEND), with its alpha multiplied by `opacity`.
/// Alpha that glTF 2.0, section 3.9.4, says to ignore stays ignored: a material that was OPAQUE
/// gets `opacity` everywhere, regardless of its texture and vertex colours. A MASK material keeps
/// the texture's alpha, without the cut-off. Surfaces without a material get one. Call it before
/// overrideLighting(), which changes transparent materials.
/// @param opacity above 0, up to 1; 1 leaves the scene exactly as it is
void overrideOpacity(Scene& scene, float opacity);

}  // namespace macula::scene
