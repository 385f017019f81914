// The few facts about a scene that decide which passes have work.
#pragma once

#include <array>
#include <cstdint>

#include "engine/scene/scene.h"

namespace macula::scene {

/// Most lights whose types shaders are specialised by: each is a copy of the lighting's code, and
/// this bounds its length.
inline constexpr std::size_t kSpecialisedLights = 8;

struct SceneFacts {
  std::uint64_t opaqueTriangles = 0;       ///< OPAQUE and MASK, over all instances
  std::uint64_t transparentTriangles = 0;  ///< without those that alpha makes invisible
  bool litOpaque = false;
  bool litTransparent = false;
  bool unlitOpaque = false;
  std::size_t lights = 0;
  std::array<LightType, kSpecialisedLights> lightTypes{};  ///< where they are no more than these
  bool shadowLight = false;                                ///< a directional light casts shadows
  std::size_t shadowLightNumber = 0;                       ///< its index
  bool environment = false;           ///< image-based light and background are given
  int shadowTaps = kUsualShadowTaps;  ///< a side of the shadow's filter
  bool veins = false;                 ///< an opaque surface has procedural veins
  AmbientOcclusion occlusion = {};    ///< asked for by the scene
};

/// @param hasEnvironment whether an environment map is given beside the scene
[[nodiscard]] SceneFacts factsOf(const Scene& scene, bool hasEnvironment);

}  // namespace macula::scene
