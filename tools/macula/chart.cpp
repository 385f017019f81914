#include "chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <set>
#include <span>
#include <thread>

#include "chart_run.h"
#include "chart_settings.h"
#include "commands.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/interrupt.h"
#include "engine/core/nearest.h"
#include "engine/core/output_folder.h"
#include "engine/core/plural.h"
#include "engine/core/sha256.h"
#include "engine/experiment/speedup.h"
#include "engine/gaze/source.h"
#include "engine/scene/load.h"
#include "engine/settings/toml_file.h"
#include "gaze_report.h"
#include "macula_version.h"
#include "provenance.h"

namespace macula::tools {
namespace {

namespace fs = std::filesystem;
using namespace experiment;

/// A file as named, or the ready-made experiment of that name.
fs::path findExperiment(const std::string& name) {
  const fs::path path(name);
  if (path.extension() == ".toml" || path.has_parent_path() || fs::is_regular_file(path)) {
    return path;
  }
  const fs::path folder = dataFolder("assets") / "experiments";
  const fs::path ready = folder / (name + ".toml");
  if (fs::exists(ready)) return ready;
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  failInput("{}: no such experiment; did you mean '{}'? Otherwise name a .toml file", name,
            nearestName(name, names));
}

std::string hashOf(std::string_view bytes) {
  return sha256Hex(std::as_bytes(std::span(bytes)));
}

/// The program itself, its shaders and networks, and where they run: numbers of another are not
/// these numbers.
std::string programFingerprint(const passes::Machine& machine) {
  std::string all = fmt::format("{} {} {} {} ", MACULA_COMMIT, machine.capabilities.renderer,
                                machine.capabilities.version, std::thread::hardware_concurrency());
  all += hashOf(readTextFile(fs::read_symlink("/proc/self/exe")));
  std::vector<fs::path> files;
  for (const fs::path& folder : {dataFolder("shaders"), dataFolder("assets") / "networks"}) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) all += hashOf(readTextFile(file));
  return hashOf(all);
}

/// Hashes of the networks that settings name in place of those of assets/.
std::string networksNamedBy(const Experiment& experiment) {
  std::string hashes;
  const auto add = [&](const VariantSettings& settings) {
    const fs::path& network = settings.render.oit.network;
    std::error_code error;
    if (fs::is_regular_file(network, error)) hashes += " " + hashOf(readTextFile(network));
  };
  for (const Study& study : experiment.studies) {
    VariantSettings shared;
    for (const toml::table* layer : study.settings) {
      settings::applyTable(shared.registry, *layer, experiment.name);
    }
    add(shared);
  }
  for (const Variant& variant : experiment.variants) {
    VariantSettings own;
    own.applyVariant(experiment, variant);
    add(own);
  }
  return hashes;
}

Fingerprint fingerprintOf(const Experiment& experiment, const passes::Machine& machine) {
  Fingerprint fingerprint{programFingerprint(machine) + networksNamedBy(experiment), {}};
  std::error_code error;
  const auto add = [&](const std::string& name) {
    if (fs::is_regular_file(name, error)) fingerprint.files[name] = hashOf(readTextFile(name));
  };
  for (const Study& study : experiment.studies) {
    for (const std::string& scene : study.scenes) add(scene);
    add(study.camera);
    add(study.gaze);
  }
  return fingerprint;
}

/// What is to be known of the gaze logs that studies name; those that cannot be read are left out
/// by the run itself, with the reason.
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

std::string processorName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

Provenance provenanceOf(const passes::Machine& machine) {
  const std::time_t now = std::time(nullptr);
  char date[16];
  std::strftime(date, sizeof(date), "%Y-%m-%d", std::gmtime(&now));
  return {MACULA_COMMIT,
          processorName(),
          static_cast<int>(std::thread::hardware_concurrency()),
          machine.capabilities.renderer,
          machine.capabilities.version,
          machine.time.source == gl::TimeSource::Finish ? "glFinish and a steady clock"
                                                        : "GL timer queries",
          date,
          {}};
}

/// What the experiment reads: lists in the order of its studies, each thing once.
/// @param name of the experiment on the command line @param file it was read from
nlohmann::ordered_json madeFrom(const Experiment& experiment, const std::string& name,
                                const fs::path& file) {
  using nlohmann::ordered_json;
  measure::Provenance made = provenanceOfRun();
  ordered_json& inputs = made.inputs;
  measure::Input own = measure::inputOf(file);
  own.name = name;
  inputs["experiment"] = measure::toJson(own);
  for (const char* key : {"scene", "gaze", "camera", "fps", "seed"}) {
    inputs[key] = ordered_json::array();
  }
  const auto add = [&](const char* key, const ordered_json& value) {
    ordered_json& list = inputs[key];
    if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
  };
  for (const Study& study : experiment.studies) {
    for (const std::string& scene : study.scenes) {
      const bool absent = scene::isSceneFile(scene) && !fs::exists(scene);  // an optional one
      if (!absent) add("scene", measure::toJson(sceneInput(scene)));
    }
    add("gaze", measure::toJson(gazeInput(study.gaze, {})));
    add("camera", measure::toJson(cameraInput(study.camera)));
    if (study.pathFrames > 0) add("fps", study.pathFps);
    for (const std::int64_t seed : study.seeds) add("seed", seed);
  }
  return measure::toJson(made);
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
  passes::Machine machine;
  const std::vector<Group> groups = expand(experiment, fingerprintOf(experiment, machine));
  output.begin();  // no file is named in it: finished points and their images stay
  ChartRun run{experiment, folder, file, machine};
  runGroups(run, groups);

  Results results{
      &experiment, provenanceOf(machine), collect(file, experiment, groups), {}, run.skipped};
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
                      "A TOML file, or quick, lod, papers or learned (default quick)");
  addOutOption(*command, options->out, options->force,
               "Folder for results.csv, results.json and report.html; finished points in it are "
               "kept")
      ->required();
  addPlatformOption(*command, options->platform);
  addJsonOption(*command, options->json);
  command->callback([options] { chart(*options); });
}

}  // namespace macula::tools
