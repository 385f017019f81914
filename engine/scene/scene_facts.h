// The few facts about a scene that decide which passes have work.
#pragma once

#include <cstdint>

#include "engine/scene/scene.h"

namespace macula::scene {

struct SceneFacts {
  std::uint64_t opaqueTriangles = 0;       ///< OPAQUE and MASK, over all instances
  std::uint64_t transparentTriangles = 0;  ///< without those that alpha makes invisible
  bool litOpaque = false;
  bool litTransparent = false;
  bool unlitOpaque = false;
  bool shadowLight = false;           ///< a directional light casts shadows
  bool environment = false;           ///< image-based light and background are given
  int shadowTaps = kUsualShadowTaps;  ///< a side of the shadow's filter
  bool veins = false;                 ///< an opaque surface has procedural veins
  AmbientOcclusion occlusion = {};    ///< asked for by the scene
};

/// @param hasEnvironment whether an environment map is given beside the scene
[[nodiscard]] SceneFacts factsOf(const Scene& scene, bool hasEnvironment);

}  // namespace macula::scene
