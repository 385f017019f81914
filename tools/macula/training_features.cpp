// The command line of `macula features`.
#include "training_features.h"

#include <memory>
#include <set>

#include "commands.h"
#include "common.h"
#include "engine/core/error.h"
#include "engine/settings/command_line.h"

namespace macula::tools {
namespace {

/// What a scene's file is called: the name of a procedural scene, or a file's without ending.
std::string stemOf(const std::string& scene) {
  return std::filesystem::path(scene).stem().string();
}

}  // namespace

std::vector<FeaturesScene> scenesOf(const FeaturesOptions& options) {
  std::vector<FeaturesScene> all;
  std::set<std::string> known;
  for (std::size_t i = 0; i < kSplits.size(); ++i) {
    for (const std::string& scene : options.scenes[i]) {
      const std::string stem = stemOf(scene);
      if (!known.insert(stem).second) {
        failInput(
            "features: '{}' is named twice; a scene belongs to one of --training, --validation "
            "and --test",
            stem);
      }
      for (std::size_t other = 0; other < kSplits.size(); ++other) {
        const auto file = options.out / kSplits[other] / (stem + ".npz");
        if (other != i && std::filesystem::exists(file)) {
          failInput(
              "{}: '{}' was written there as a scene of another split; remove it, or choose "
              "another --out",
              file.string(), stem);
        }
      }
      all.push_back({scene, kSplits[i], options.out / kSplits[i] / (stem + ".npz")});
    }
  }
  if (all.empty()) failInput("features: name scenes, as --training medley-0 medley-1");
  return all;
}

void addFeatures(CLI::App& root) {
  constexpr int kMostViews = 1000;
  auto o = std::make_shared<FeaturesOptions>();
  passes::registerSettings(o->registry, o->settings);
  CLI::App* command = root.add_subcommand(
      "features", "Writes what networks of importance are trained on, as NumPy files");
  for (std::size_t i = 0; i < kSplits.size(); ++i) {
    command->add_option("--" + std::string(kSplits[i]), o->scenes[i],
                        "Scenes of this split: files or procedural names");
  }
  addOutOption(*command, o->out, o->force, "Folder; one file a scene, in a folder for each split")
      ->required();
  command->add_option("--size", o->size, "WIDTHxHEIGHT of a view (default 256x256)");
  command
      ->add_option("--views", o->views,
                   "Views of each scene: its own camera's and a turn around it (default 8)")
      ->check(CLI::Range(1, kMostViews));
  command->add_option("--sample", o->sample, "Share of the covered pixels (default 0.13)")
      ->check(settings::shareIn({.min = 0.0, .max = 1.0}));
  command
      ->add_option("--shares", o->shares,
                   "Budgets that labels are found for, as shares of all fragments (default 0.1 0.2 "
                   "0.3 0.4 0.5)")
      ->check(settings::shareIn({.min = 0.0, .max = 1.0}));
  addPlatformOption(*command, o->platform);
  addJsonOption(*command, o->json);
  settings::addOptions(*command, o->registry);
  command->callback([o, command] {
    settings::applyOptions(*command, o->registry);
    writeFeatures(*o);
  });
}

}  // namespace macula::tools
