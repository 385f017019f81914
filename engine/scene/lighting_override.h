// The same geometry lit or unlit, so that what lighting costs and hides can be measured.
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
/// Comes before addDefaultLights().
void overrideLighting(Scene& scene, LightingOverride lighting);

}  // namespace macula::scene
