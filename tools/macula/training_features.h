// `macula features`: what networks of importance are trained on.
#pragma once

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "engine/settings/registry.h"
#include "passes/render_settings.h"

namespace macula::tools {

/// Which scenes a network learns from, which tell when to stop, and which it is judged by.
inline constexpr std::array<const char*, 3> kSplits{"training", "validation", "test"};

struct FeaturesOptions {
  std::array<std::vector<std::string>, kSplits.size()> scenes;  ///< by split
  std::string size = "256x256";
  int views = 8;         ///< of each scene
  double sample = 0.13;  ///< share of the covered pixels (Tsopouridis 2021, section 4.2.3)
  std::vector<double> shares{0.1, 0.2, 0.3, 0.4, 0.5};  ///< budgets, of all fragments of a view
  std::filesystem::path out;
  bool force = false;  ///< it may hold something else
  std::string platform = "auto";
  std::string json;
  settings::Registry registry;
  passes::RenderSettings settings;
};

/// A scene of a split, and the file that its features go to.
struct FeaturesScene {
  std::string scene;  ///< name or path
  std::string split;
  std::filesystem::path file;
};

/// Every scene of the options. @throws InputError where a scene stands in two splits, or an earlier
/// call wrote it into another
[[nodiscard]] std::vector<FeaturesScene> scenesOf(const FeaturesOptions& options);

/// Renders the scenes and writes a file for each.
void writeFeatures(const FeaturesOptions& options);

}  // namespace macula::tools
