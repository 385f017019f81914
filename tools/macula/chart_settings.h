// The settings of an experiment, through the registry.
#pragma once

#include <optional>

#include "engine/experiment/plan.h"
#include "engine/settings/registry.h"
#include "passes/render_settings.h"

namespace macula::tools {

/// Render settings with their registry; stays where it is, because both point into it.
struct VariantSettings {
  VariantSettings();
  VariantSettings(const VariantSettings&) = delete;
  VariantSettings& operator=(const VariantSettings&) = delete;

  /// What all variants of a group share: the study's settings, seed and light.
  /// @throws InputError naming file and line
  void applyGroup(const experiment::Experiment& experiment, const experiment::Group& group);
  void applyVariant(const experiment::Experiment& experiment, const experiment::Variant& variant);
  /// @param value of the sweep
  /// @throws InputError naming file and line
  void applySweep(const experiment::Sweep& sweep, double value);
  /// @param bytes of the budget, where it is no k_ave
  void applyBudget(const experiment::Budget& budget, double bytes);

  passes::RenderSettings render;
  settings::Registry registry;
};

/// Refuses what the registry does not take, variants that change what a scene's loading decides by
/// (those settings belong to a study), and scenes that are neither files nor procedural.
/// @throws InputError naming file and line
void checkExperiment(const experiment::Experiment& experiment);

/// Why a group cannot be measured here at all: its file is missing, or this build cannot light it.
[[nodiscard]] std::optional<std::string> reasonToSkip(const experiment::Group& group);

}  // namespace macula::tools
