// What an experiment leaves behind: results.json and report.html.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "engine/experiment/target.h"

namespace macula::experiment {

/// Where and by what the points were measured.
struct Provenance {
  std::string commit;
  std::string processor;
  int cores = 0;
  std::string renderer;  ///< GL_RENDERER
  std::string version;   ///< GL_VERSION
  std::string timeSource;
  std::string date;                  ///< UTC, "2026-11-22"
  nlohmann::ordered_json made = {};  ///< command line and inputs: of measure::Provenance
};

/// A scene that was not measured, or a variant on it, and why.
struct Skipped {
  std::string what;
  std::string reason;
};

struct Results {
  const Experiment* experiment = nullptr;
  Provenance provenance;
  std::vector<Point> points;
  std::vector<TargetRow> targets;
  std::vector<Skipped> skipped;
  std::string interrupted = {};            ///< how far it came; empty: all points were seen to
  std::vector<std::string> warnings = {};  ///< of the gaze logs that studies name
};

/// results.json; README.md of this folder has its keys.
[[nodiscard]] nlohmann::ordered_json toJson(const Results& results);

/// One page that needs nothing else: the template of assets/report, the results and the pictures,
/// at most Experiment::reportPixels wide.
/// @param folder where the points' images lie
/// @param assets the folder "assets"
/// @throws InputError where a file of either is missing
[[nodiscard]] std::string reportPage(const Results& results, const std::filesystem::path& folder,
                                     const std::filesystem::path& assets);

}  // namespace macula::experiment
