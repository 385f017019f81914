// macula hold --plant: the protocol of control laws on a simulated GPU.
#include <fmt/format.h>

#include "engine/control/plant.h"
#include "engine/core/file.h"
#include "engine/core/interrupt.h"
#include "engine/core/output_folder.h"
#include "engine/core/page.h"
#include "hold.h"
#include "macula_version.h"
#include "provenance.h"

namespace macula::tools {
namespace {

using Json = nlohmann::ordered_json;

/// Thousandths are finer than any difference that matters, and keep the page small.
double rounded(double value) {
  return std::round(value * 1e3) / 1e3;
}

Json measuresJson(const control::PlantMeasures& m) {
  return {{"settle_frames", m.settleFrames ? Json(*m.settleFrames) : Json(nullptr)},
          {"over_share", m.overShare},
          {"used_pixels", m.usedPixels},
          {"limit_cycle", m.limitCycle},
          {"sigma_ms", m.sigmaMs},
          {"p99_ms", m.p99Ms},
          {"bias_ms", m.biasMs},
          {"p50_ms", m.p50Ms},
          {"p95_ms", m.p95Ms},
          {"over_110_share", m.over110Share},
          {"longest_over", m.longestOver},
          {"changes_per_s", m.changesPerSecond},
          {"reversals_per_s", m.reversalsPerSecond}};
}

/// Frame times and r of one run, for the charts.
Json traceOf(const std::string& name, const control::PlantCase& given,
             const control::LawOptions& givenOptions) {
  const auto [plantCase, options] = control::withStep(given, givenOptions);
  const auto law = control::makeLaw(name, options);
  const control::PlantRun run = control::runPlant(*law, plantCase, options.targetMs, 1);
  Json times = Json::array();
  Json factors = Json::array();
  for (const control::PlantFrame& frame : run.frames) {
    times.push_back(rounded(frame.spentMs));
    factors.push_back(rounded(frame.resize));
  }
  return {{"ms", times}, {"r", factors}, {"notice", run.notice}};
}

std::string csvOf(const Json& results) {
  std::string csv = "law,case";
  const Json& any = results["laws"].front().front();
  for (const auto& [key, value] : any.items()) csv += "," + key;
  csv += "\n";
  for (const auto& [law, cases] : results["laws"].items()) {
    for (const auto& [name, measures] : cases.items()) {
      csv += law + "," + name;
      for (const auto& [key, value] : measures.items()) {
        csv += "," + (value.is_null() ? "" : value.dump());
      }
      csv += "\n";
    }
  }
  return csv;
}

void writeFiles(const Json& results, const Json& traces,
                const std::vector<control::PlantCase>& cases, const std::string& interrupted,
                OutputFolder& output) {
  writeFileAtomically(output.file("results.json"), results.dump(1) + "\n");
  writeFileAtomically(output.file("results.csv"), csvOf(results));
  Json data = results;
  data["traces"] = traces;
  data["cases"] = Json::array();
  for (const control::PlantCase& plantCase : cases) {
    data["cases"].push_back({{"name", plantCase.name},
                             {"title", plantCase.title},
                             {"dead_frames", plantCase.deadFrames},
                             {"step_frame", plantCase.stepFrame},
                             {"steady_from", plantCase.steadyFrom}});
  }
  writeFileAtomically(output.file("report.html"),
                      reportPageOf(dataFolder("assets"), "plant", data.dump(),
                                   {{"interrupted", interruptedBanner(interrupted)}}));
}

}  // namespace

void holdPlant(const HoldOptions& options) {
  const InterruptGuard guard;
  std::optional<OutputFolder> output;
  if (!options.out.empty()) output.emplace(options.out, "hold", options.force);
  const control::LawOptions law = control::lawOptionsOf(options.control);
  Json results{{"schema", 1},
               {"commit", MACULA_COMMIT},
               {"target_ms", law.targetMs},
               {"most_r", law.mostResize},
               {"r_step", law.resizeStep},
               {"expected_work_ms", law.expectedWorkMs},
               {"least_aim", law.leastAim},
               {"seeds", options.seeds},
               {"provenance", measure::toJson(provenanceOfRun(options.registry))},
               {"interrupted", false},
               {"laws", Json::object()}};
  Json traces = Json::object();
  std::vector<control::PlantCase> cases = control::plantCases();
  const std::vector<std::string> names = control::lawNames();
  ProgressBar progress("plant", static_cast<int>(names.size() * cases.size()));
  std::size_t finished = 0;  // cases that every law was run on: laws are compared on equal terms
  for (; finished < cases.size() && !interruptAsked(); ++finished) {
    const control::PlantCase& plantCase = cases[finished];
    std::vector<std::pair<Json, Json>> ofLaws;  // measures and trace
    for (const std::string& name : names) {
      ofLaws.emplace_back(measuresJson(control::measureLaw(name, plantCase, law, options.seeds)),
                          output ? traceOf(name, plantCase, law) : Json());
      progress.advance();
      if (interruptAsked()) break;
    }
    if (ofLaws.size() < names.size()) break;
    for (std::size_t i = 0; i < names.size(); ++i) {
      results["laws"][names[i]][plantCase.name] = std::move(ofLaws[i].first);
      if (output) traces[names[i]][plantCase.name] = std::move(ofLaws[i].second);
    }
  }
  progress.end();
  if (finished == 0) endIfInterrupted();
  std::string interrupted;
  if (finished < cases.size()) {
    interrupted = fmt::format("{} of {} cases were run", finished, cases.size());
    results["interrupted"] = true;
    cases.resize(finished);
  }
  writeJson(options.json, results);
  if (output) writeFiles(results, traces, cases, interrupted, *output);
  if (output && options.json != "-") {
    fmt::print("report: {}\n", (output->path() / "report.html").string());
  }
  if (!interrupted.empty()) {
    throw Interrupted(fmt::format("interrupted: {}{}", interrupted,
                                  output ? "; they are in " + options.out : ""));
  }
}

}  // namespace macula::tools
