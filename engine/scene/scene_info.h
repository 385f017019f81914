// Counts of a scene: triangles, draws, materials, lights, textures.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene {

/// Triangles and draws count over instances: a triangle placed twice counts twice.
struct SceneInfo {
  std::uint64_t triangles = 0;
  std::uint64_t draws = 0;                  ///< instances
  std::uint64_t maskTriangles = 0;          ///< AlphaMode::Mask
  std::uint64_t blendTriangles = 0;         ///< AlphaMode::Blend
  std::uint64_t transmissionTriangles = 0;  ///< KHR_materials_transmission above 0
  std::uint64_t transparentTriangles = 0;   ///< either of the last two
  struct Materials {
    int opaque = 0;
    int mask = 0;
    int blend = 0;
  } materials;       ///< of the file, used or not, by alpha mode
  int lights = 0;    ///< before addDefaultLights(), those of the file
  int textures = 0;  ///< images of the file
  std::vector<std::string> unsupportedExtensions;
  std::vector<std::string> warnings;
};

/// Counts a scene.
[[nodiscard]] SceneInfo describe(const Scene& scene);

/// The object that `macula scene info --json` prints, without "passes".
[[nodiscard]] nlohmann::ordered_json toJson(const SceneInfo& info);

}  // namespace macula::scene
