#include "chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>

#include "chart_inputs.h"
#include "chart_run.h"
#include "chart_settings.h"
#include "commands.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/interrupt.h"
#include "engine/core/output_folder.h"
#include "engine/core/plural.h"
#include "engine/experiment/speedup.h"
#include "engine/gaze/source.h"
#include "gaze_report.h"

namespace macula::tools {
namespace {

namespace fs = std::filesystem;
using namespace experiment;

/// Warnings about the gaze logs that studies name. The run itself leaves out those that cannot be
/// read, and gives the reason.
std::vector<std::string> gazeWarnings(const Experiment& experiment) {
  const gaze::GazeSettings settings;
  std::vector<std::string> all;
  std::set<std::string> names;
  for (const Study& study : experiment.studies) names.insert(study.gaze);
  for (const std::string& name : names) {
    try {
      const auto source = gaze::parseGazeSpec(name);
      for (std::string& warning : FollowedGaze(*source, settings).warnings()) {
        fmt::print(stderr, "warning: {}\n", warning);
        all.push_back(std::move(warning));
      }
    } catch (const InputError&) {
      continue;
    }
  }
  return all;
}

std::vector<Point> collect(const PointsFile& file, const Experiment& experiment,
                           std::span<const Group> groups) {
  std::vector<Point> points;
  for (const Group& group : groups) {
    for (const Batch& batch : group.batches) {
      for (const PointPlan& plan : batch.points) {
        const Point* found = file.find(plan.key);
        if (found == nullptr) continue;
        points.push_back(*found);
        // May have been reworded.
        points.back()["label"] = experiment.variants[plan.variant].labelAt(plan.value);
      }
    }
  }
  experiment::giveSpeedups(experiment, points);
  return points;
}

std::size_t pointsOf(std::span<const Group> groups) {
  std::size_t points = 0;
  for (const Group& group : groups) {
    for (const Batch& batch : group.batches) points += batch.points.size();
  }
  return points;
}

void writeResults(const Results& results, const fs::path& folder) {
  writeFileAtomically(folder / "results.csv", toCsv(results.points));
  writeFileAtomically(folder / "results.json", toJson(results).dump(1) + "\n");
  writeFileAtomically(folder / "report.html", reportPage(results, folder, dataFolder("assets")));
}

/// "met", "n/a: everything fits"
std::string verdictOf(const TargetRow& row) {
  return std::string(nameOf(row.state)) + (row.reason.empty() ? "" : ": " + row.reason);
}

void printSummary(const Results& results, const ChartRun& run, const fs::path& folder) {
  std::size_t refused = 0;
  for (const Point& point : results.points) refused += point["status"] == kRefused ? 1 : 0;
  for (const Skipped& skipped : run.skipped) {
    fmt::print("skipped: {}: {}\n", skipped.what, oneLine(skipped.reason));
  }
  constexpr std::size_t kLeastWidth = 10;
  std::size_t width = kLeastWidth;
  const Target* before = nullptr;
  for (const TargetRow& row : results.targets) {
    if (row.target != before) {
      fmt::print("{}: {} {}\n", row.target->name, row.target->metric, row.target->limitText());
      width = kLeastWidth;
      for (const TargetRow& other : results.targets) {
        if (other.target == row.target) width = std::max(width, verdictOf(other).size());
      }
    }
    before = row.target;
    const std::string value = row.value ? fmt::format("{:.3g}", *row.value) : "";
    std::string where = row.where;
    if (row.state == TargetRow::State::Unmeasured) where += (where.empty() ? "" : ": ") + row.note;
    fmt::print("  {:<{}} {:>7}  {}\n", verdictOf(row), width, value, where);
  }
  if (!results.targets.empty()) fmt::print("targets: {}\n", summaryOf(results.targets));
  fmt::print("{}: {} measured now, {} kept, {} refused\nreport: {}\n",
             counted(results.points.size(), "point"), run.measured, run.kept, refused,
             (folder / "report.html").string());
}

}  // namespace

void chart(const ChartOptions& options) {
  const fs::path path = findExperiment(options.experiment);
  const Experiment experiment = parseExperiment(readTextFile(path), path.string());
  checkExperiment(experiment);
  const InterruptGuard guard;
  const fs::path folder(options.out);
  const nlohmann::ordered_json made = madeFrom(experiment, options.experiment, path);
  OutputFolder output(folder, "chart", options.force);
  PointsFile file(folder / "points.jsonl");

  const window::HeadlessContext context(platformOf(options.platform));
  passes::DeviceContext device;
  const std::vector<Group> groups = expand(experiment, fingerprintOf(experiment, device));
  output.begin();  // no file is named in it: finished points and their images stay
  ChartRun run{experiment, folder, file, device};
  runGroups(run, groups);

  Results results{
      &experiment, provenanceOf(device), collect(file, experiment, groups), {}, run.skipped};
  results.warnings = gazeWarnings(experiment);
  results.provenance.made = made;
  results.targets = judge(experiment, results.points);
  if (run.interrupted) {
    if (results.points.empty()) endIfInterrupted();
    results.interrupted =
        fmt::format("{} of {} points are finished", results.points.size(), pointsOf(groups));
  }
  writeResults(results, folder);
  writeJson(options.json, toJson(results));
  if (run.interrupted) {
    throw Interrupted(
        fmt::format("interrupted: {}; the same command goes on from there", results.interrupted));
  }
  if (options.json != "-") printSummary(results, run, folder);
}

void addChart(CLI::App& root) {
  auto options = std::make_shared<ChartOptions>();
  CLI::App* command = root.add_subcommand(
      "chart", "Runs an experiment: errors, times and bytes of variants, as table and report");
  command->add_option("experiment", options->experiment,
                      "A TOML file, or quick, lod, papers, learned or gpu (default quick)");
  addOutOption(*command, options->out, options->force,
               "Folder for results.csv, results.json and report.html; finished points in it are "
               "kept")
      ->required();
  addPlatformOption(*command, options->platform);
  addJsonOption(*command, options->json);
  command->callback([options] { chart(*options); });
}

}  // namespace macula::tools
