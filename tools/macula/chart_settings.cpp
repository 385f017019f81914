#include "chart_settings.h"

#include <fmt/format.h>

#include <filesystem>

#include "engine/core/error.h"
#include "engine/scene/load.h"
#include "engine/settings/toml_file.h"

namespace macula::tools {
namespace {

constexpr const char* kLightingKey = "scene.lighting";
constexpr const char* kSeedKey = "frame.seed";
constexpr const char* kAverageKey = "oit.kAve";
constexpr const char* kMemoryKey = "oit.memoryMiB";
constexpr double kMebi = 1024.0 * 1024.0;

void checkScene(const std::string& scene, const experiment::Study& study) {
  if (scene::isSceneFile(scene)) return;
  if (study.isOptional(scene)) {
    failInput("{}: optional_scenes: '{}' is no .gltf or .glb file; name it under scenes",
              study.place, oneLine(scene));
  }
  if (!scene::isProcedural(scene)) {
    failInput("{}: scenes: '{}': {}", study.place, oneLine(scene), scene::unknownScene(scene));
  }
}

/// The settings of a study's variant lie over each other: no two of them may be rival budgets.
void checkBudgets(const experiment::Experiment& experiment, const experiment::Study& study,
                  const experiment::Variant& variant) {
  VariantSettings all;
  for (const toml::table* layer : study.settings) {
    settings::applyTable(all.registry, *layer, experiment.name);
  }
  all.registry.checkRivals();
  if (variant.budgets) return;  // of the study, in place of these
  all.applyVariant(experiment, variant);
  all.registry.checkRivals();
  if (!variant.sweep) return;
  for (const double value : variant.sweep->values) {
    all.applySweep(*variant.sweep, value);
    all.registry.checkRivals();
  }
}

void requireTimes(const VariantSettings& settings, const std::string& place) {
  if (!settings.render.timing) {
    failInput("{}: a chart needs the times of frames; leave frame.timing on", place);
  }
}

/// A variant that is measured at budgets has none of its own.
void requireNoBudget(const VariantSettings& own, const experiment::Variant& variant) {
  if (!variant.budgets) return;
  for (const char* key : {kAverageKey, kMemoryKey}) {
    const settings::Entry* entry = own.registry.find(key);
    if (entry->setAt().empty()) continue;
    failInput("{}: variant '{}' is measured at the budgets of its study; drop it, or budgets",
              entry->setAt(), variant.id);
  }
}

/// All variants of a group share its loaded scene.
void requireNoLoading(const VariantSettings& settings, const experiment::Variant& variant) {
  for (const settings::Entry& entry : settings.registry.entries()) {
    if (entry.effect() == settings::Effect::ReloadsScene && !entry.isDefault()) {
      failInput(
          "{}: {} decides what is loaded; give it under settings of the experiment or of "
          "a [[study]]",
          variant.place, entry.key());
    }
  }
}

}  // namespace

VariantSettings::VariantSettings() {
  passes::registerSettings(registry, render);
}

void VariantSettings::applyGroup(const experiment::Experiment& experiment,
                                 const experiment::Group& group) {
  const experiment::Study& study = experiment.studies[group.study];
  for (const toml::table* layer : study.settings) {
    settings::applyTable(registry, *layer, experiment.name);
  }
  registry.at(kSeedKey, study.place).set(group.seed, study.place + ": seeds");
  if (settings::Entry* lighting = registry.find(kLightingKey)) {
    lighting->set(group.light, study.place + ": lights");
  }
  render.tonemap.linearOut = true;  // errors are of values before rounding to 8 bits
}

void VariantSettings::applyVariant(const experiment::Experiment& experiment,
                                   const experiment::Variant& variant) {
  if (variant.settings != nullptr) {
    settings::applyTable(registry, *variant.settings, experiment.name);
  }
}

void VariantSettings::applySweep(const experiment::Sweep& sweep, double value) {
  // As text, because a whole number is taken for both kinds of numbers then.
  registry.setText(sweep.setting, fmt::format("{}", value), sweep.place + ": sweep");
}

void VariantSettings::applyBudget(const experiment::Budget& budget, double bytes) {
  if (budget.kind == experiment::Budget::Kind::KAve) {
    registry.at(kAverageKey, "k_ave").set(budget.value, "k_ave");
    registry.at(kMemoryKey, "k_ave").set(0.0, "k_ave");
  } else {
    registry.at(kMemoryKey, "mib").set(bytes / kMebi, budget.label());
  }
}

void checkExperiment(const experiment::Experiment& experiment) {
  for (const experiment::Study& study : experiment.studies) {
    for (const std::string& scene : study.scenes) checkScene(scene, study);
    VariantSettings shared;
    for (const toml::table* layer : study.settings) {
      settings::applyTable(shared.registry, *layer, experiment.name);
    }
    requireTimes(shared, study.place);
    if (settings::Entry* lighting = shared.registry.find(kLightingKey)) {
      for (const std::string& light : study.lights) lighting->set(light, study.place + ": lights");
    }
  }
  for (const experiment::Variant& variant : experiment.variants) {
    VariantSettings own;
    own.applyVariant(experiment, variant);
    requireTimes(own, variant.place);
    requireNoLoading(own, variant);
    requireNoBudget(own, variant);
    if (!variant.sweep) continue;
    for (const double value : variant.sweep->values) {
      own.applySweep(*variant.sweep, value);
      requireNoLoading(own, variant);
    }
  }
  for (const experiment::Study& study : experiment.studies) {
    for (const std::string& id : study.variants) {
      checkBudgets(experiment, study, experiment.variant(id));
    }
  }
}

std::optional<std::string> reasonToSkip(const experiment::Group& group) {
  std::error_code error;
  if (scene::isSceneFile(group.scene) && !std::filesystem::exists(group.scene, error)) {
    return group.scene + ": no such file";
  }
  if (group.light != experiment::kOwnLight &&
      VariantSettings().registry.find(kLightingKey) == nullptr) {
    return "this build has no setting scene.lighting for '" + group.light + "'";
  }
  return std::nullopt;
}

}  // namespace macula::tools
