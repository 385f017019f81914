// Runs the groups of an experiment that have no points yet.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "common.h"
#include "engine/experiment/points_file.h"
#include "engine/experiment/report.h"
#include "passes/device_context.h"

namespace macula::tools {

/// What a run needs and what it counts.
struct ChartRun {
  const experiment::Experiment& experiment;
  std::filesystem::path folder;
  experiment::PointsFile& file;
  passes::DeviceContext& device;
  std::vector<experiment::Skipped> skipped = {};  ///< groups, and references that were refused
  std::size_t kept = 0;                           ///< points that were there already
  std::size_t measured = 0;
  bool interrupted = false;
};

/// Measures every batch of `groups` that is not in the points file, and appends it when it is
/// finished. Ends early after SIGINT or SIGTERM, between two rounds.
void runGroups(ChartRun& run, std::span<const experiment::Group> groups);

}  // namespace macula::tools
