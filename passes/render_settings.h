// Every setting of the renderer, and their registration.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>

#include "engine/scene/draw_order.h"
#include "engine/scene/material_override.h"
#include "engine/settings/registry.h"
#include "passes/heatmap_pass.h"
#include "passes/lod/settings.h"
#include "passes/oit/plan.h"
#include "passes/shadow_pass.h"
#include "passes/tonemap_pass.h"

namespace macula::passes {

struct RenderSettings {
  OitSettings oit;
  ImportanceSettings importance;
  ShadowPass::Settings shadow;
  LodSettings lod;
  FoveationSettings foveation;
  TonemapPass::Settings tonemap;
  HeatmapPass::Settings heatmap;
  std::filesystem::path environment;  ///< equirectangular panorama; empty: none
  glm::vec3 background{0.0F};         ///< linear RGB
  float opacity = 1.0F;               ///< above 0, up to 1; see scene::overrideOpacity
  scene::LightingOverride lighting = scene::LightingOverride::Own;
  scene::TransparentOrder order = scene::TransparentOrder::File;
  std::uint32_t seed = 1;  ///< of noise and procedural scenes
  bool timing = true;      ///< passes are timed where times are asked for
  bool readBack = false;   ///< buffers stay as the frame left them, for readers; costs memory
};

/// The same view by the exact method, without options of other methods: errors are measured against
/// it.
[[nodiscard]] RenderSettings referenceOf(const RenderSettings& settings);

/// Registers all of them; `settings` must outlive the registry.
void registerSettings(settings::Registry& registry, RenderSettings& settings);

}  // namespace macula::passes
