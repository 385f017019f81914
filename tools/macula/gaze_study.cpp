// macula gaze study LOG... --out DIR: how far the point of interest is from the eye under latency.
#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "common.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/interrupt.h"
#include "engine/core/output_folder.h"
#include "engine/core/page.h"
#include "engine/gaze/point_error.h"
#include "engine/gaze/viewing.h"
#include "engine/measure/statistics.h"
#include "engine/settings/command_line.h"
#include "gaze_report.h"
#include "macula_version.h"
#include "provenance.h"

namespace macula::tools {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> files;
  std::vector<double> latenciesMs{0.0, 20.0, 40.0, 60.0, 80.0, 100.0, 150.0, 200.0};
  double fps = 60.0;
  std::string out;
  bool force = false;  ///< --out may hold something else
  std::string json;
  gaze::GazeSettings settings;
  settings::Registry registry;
};

struct Way {
  const char* name;
  gaze::FilterChoice filter;
  gaze::Prediction prediction;
};

/// Every way from believed samples to the point, in the order of the report.
constexpr std::array<Way, 4> kWays{{
    {"as recorded", gaze::FilterChoice::None, gaze::Prediction::None},
    {"landing", gaze::FilterChoice::None, gaze::Prediction::Landing},
    {"one-euro", gaze::FilterChoice::OneEuro, gaze::Prediction::None},
    {"one-euro, landing", gaze::FilterChoice::OneEuro, gaze::Prediction::Landing},
}};

Json statistics(const std::vector<double>& errors) {
  const auto orNull = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  return {{"frames", errors.size()},
          {"mean", orNull(measure::mean(errors))},
          {"median", orNull(measure::median(errors))},
          {"p95", orNull(measure::p95(errors))}};
}

/// The points that were finished; fewer than asked for only where the run was interrupted.
Json studyOf(const std::string& file, const Options& options, ProgressBar& progress) {
  const gaze::LogOptions logOptions = gaze::logOptionsOf(options.settings);
  const gaze::GazeLog log = gaze::readGazeLog(file, logOptions);
  const gaze::Viewing viewing = viewingOf(log, logOptions);
  if (!viewing.hasDegrees) failInput("{}: {}", oneLine(file), gaze::kNoDegrees);
  for (const std::string& warning : viewing.warnings) {
    fmt::print(stderr, "warning: {}: {}\n", oneLine(file), warning);
  }
  gaze::GazeSettings known = options.settings;
  known.display = viewing.display.display;
  const gaze::LandingErrors landing = gaze::landingErrors(log, known);
  Json points = Json::array();
  for (const Way& way : kWays) {
    for (const double latency : options.latenciesMs) {
      if (interruptAsked()) break;
      gaze::GazeSettings settings = known;
      settings.pipeline.filter = way.filter;
      settings.pipeline.prediction = way.prediction;
      settings.latencyMs = latency;
      Json point{{"way", way.name},
                 {"latency_ms", latency},
                 {"zero_by_definition", gaze::isUndelayed(settings)}};
      point["error_deg"] = statistics(gaze::pointErrors(log, settings, options.fps));
      points.push_back(std::move(point));
      progress.advance();
    }
  }
  return {{"log", fs::path(file).filename().string()},
          {"format", log.format},
          {"coordinates", describe(log.coordinates)},
          {"display", toJson(viewing.display)},
          {"display_statement", describe(viewing.display)},
          {"warnings", viewing.warnings},
          {"points", points},
          {"landing_error_deg",
           {{"predicted", statistics(landing.predicted)},
            {"unpredicted", statistics(landing.unpredicted)}}}};
}

std::string csvOf(const Json& results) {
  const auto text = [](const Json& value) { return value.is_null() ? "" : value.dump(); };
  std::string csv = "log,way,latency_ms,frames,mean_deg,median_deg,p95_deg,display\n";
  for (const Json& log : results["logs"]) {
    for (const Json& point : log["points"]) {
      const Json& error = point["error_deg"];
      csv += fmt::format("\"{}\",\"{}\",{},{},{},{},{},\"{}\"\n", log["log"].get<std::string>(),
                         point["way"].get<std::string>(), text(point["latency_ms"]),
                         text(error["frames"]), text(error["mean"]), text(error["median"]),
                         text(error["p95"]), log["display_statement"].get<std::string>());
    }
  }
  return csv;
}

Json provenanceOf(const Options& options) {
  measure::Provenance provenance = provenanceOfRun(options.registry);
  Json logs = Json::array();
  for (const std::string& file : options.files) {
    logs.push_back(measure::toJson(gazeInput(file, gaze::logOptionsOf(options.settings))));
  }
  provenance.inputs.update({{"gaze", logs}, {"fps", options.fps}, {"seed", nullptr}});
  return measure::toJson(provenance);
}

void study(const Options& options) {
  const InterruptGuard guard;
  OutputFolder output(options.out, "gaze study", options.force);
  Json results{{"schema", 1},
               {"commit", MACULA_COMMIT},
               {"fps", options.fps},
               {"settings", Json(options.registry.toJson())},
               {"provenance", provenanceOf(options)},
               {"interrupted", false},
               {"logs", Json::array()}};
  const std::size_t asked = options.files.size() * kWays.size() * options.latenciesMs.size();
  ProgressBar progress("gaze study", static_cast<int>(asked));
  std::size_t finished = 0;
  for (const std::string& file : options.files) {
    if (interruptAsked()) break;
    Json log = studyOf(file, options, progress);
    finished += log["points"].size();
    if (!log["points"].empty()) results["logs"].push_back(std::move(log));
  }
  progress.end();
  if (finished == 0) endIfInterrupted();
  std::string interrupted;
  if (finished < asked) interrupted = fmt::format("{} of {} points were found", finished, asked);
  results["interrupted"] = !interrupted.empty();
  const std::string page = reportPageOf(dataFolder("assets"), "gaze", results.dump(),
                                        {{"interrupted", interruptedBanner(interrupted)}});
  writeFileAtomically(output.file("results.json"), results.dump(1) + "\n");
  writeFileAtomically(output.file("results.csv"), csvOf(results));
  writeFileAtomically(output.file("report.html"), page);
  writeJson(options.json, results);
  if (options.json != "-") {
    fmt::print("report: {}\n", (output.path() / "report.html").string());
  }
  if (!interrupted.empty()) {
    throw Interrupted(fmt::format("interrupted: {}; they are in {}", interrupted, options.out));
  }
}

}  // namespace

void addGazeStudy(CLI::App& gaze) {
  auto o = std::make_shared<Options>();
  gaze::registerSettings(o->registry, o->settings);
  CLI::App* command =
      gaze.add_subcommand("study", "Error of the point of interest under latency, charted");
  command->add_option("files", o->files, "Gaze logs")->required();
  command
      ->add_option("--latencies", o->latenciesMs,
                   "Latencies in ms, with commas (default 0,20,40,60,80,100,150,200)")
      ->delimiter(',')
      ->check(CLI::Range(0.0, 10000.0));
  command->add_option("--fps", o->fps, "Frames a second (default 60)")
      ->check(CLI::Range(0.001, 100000.0));
  addOutOption(*command, o->out, o->force, "Folder for results.csv, results.json and report.html")
      ->required();
  addJsonOption(*command, o->json);
  settings::addOptions(*command, o->registry);
  command->callback([o, command] {
    settings::applyOptions(*command, o->registry);
    study(*o);
  });
}

}  // namespace macula::tools
