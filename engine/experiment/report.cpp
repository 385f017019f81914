#include "engine/experiment/report.h"

#include <array>
#include <sstream>
#include <string_view>

#include "engine/core/file.h"
#include "engine/core/page.h"
#include "engine/experiment/picture.h"

namespace macula::experiment {
namespace {

using Json = nlohmann::ordered_json;

/// Every picture once, by the path that points name it by.
Json picturesOf(const Results& results, const std::filesystem::path& folder) {
  Json pictures = Json::object();
  for (const Point& point : results.points) {
    if (!point.contains("images")) continue;
    for (const auto& [role, file] : point["images"].items()) {
      const std::string name = file.get<std::string>();
      if (!pictures.contains(name)) {
        pictures[name] = pictureUri(folder / name, results.experiment->reportPixels);
      }
    }
  }
  return pictures;
}

/// The metrics that the page shows: what they are called, and where they stand in a point.
Json metricsJson() {
  constexpr std::array<std::string_view, 3> kBetter{"", "lower", "higher"};
  Json all = Json::array();
  for (const measure::Metric& metric : measure::kMetrics) {
    if (!metric.in(measure::kPage)) continue;
    Json path = Json::array();
    std::istringstream levels{std::string(metric.pointName())};
    for (std::string level; std::getline(levels, level, '.');) path.push_back(level);
    if (metric.spread) path.push_back("median");
    all.push_back({{"id", metric.columnName()},
                   {"title", metric.title},
                   {"unit", metric.unit},
                   {"better", kBetter[static_cast<std::size_t>(metric.better)]},
                   {"path", path}});
  }
  return all;
}

}  // namespace

nlohmann::ordered_json toJson(const Results& results) {
  const Experiment& experiment = *results.experiment;
  Json studies = Json::array();
  for (const Study& study : experiment.studies) {
    studies.push_back({{"id", study.id},
                       {"title", study.title},
                       {"camera", study.camera},
                       {"gaze", study.gaze},
                       {"base", study.base.empty() ? Json(nullptr) : Json(study.base)},
                       {"pixels_per_degree", study.pixelsPerDegree},
                       {"frames", study.frames},
                       {"path_frames", study.pathFrames},
                       {"path_fps", study.pathFps}});
  }
  Json variants = Json::array();
  for (const Variant& variant : experiment.variants) {
    const Json sweep = variant.sweep ? Json(variant.sweep->setting) : Json(nullptr);
    variants.push_back({{"id", variant.id}, {"label", variant.label}, {"sweep", sweep}});
  }
  Json skipped = Json::array();
  for (const Skipped& entry : results.skipped) {
    skipped.push_back({{"what", entry.what}, {"reason", entry.reason}});
  }
  const Provenance& p = results.provenance;
  return {{"schema", 1},
          {"title", experiment.title},
          {"description", experiment.description},
          {"commit", p.commit},
          {"date", p.date},
          {"provenance", p.made},
          {"machine", {{"processor", p.processor}, {"cores", p.cores}}},
          {"gl", {{"renderer", p.renderer}, {"version", p.version}, {"time_source", p.timeSource}}},
          {"warm_up_rounds", kWarmUpRounds},
          {"difference_scale",
           experiment.differenceScale > 0.0 ? Json(experiment.differenceScale) : Json(nullptr)},
          {"studies", studies},
          {"variants", variants},
          {"interrupted", !results.interrupted.empty()},
          {"skipped", skipped},
          {"warnings", results.warnings},
          {"targets", toJson(std::span<const TargetRow>(results.targets))},
          {"points", results.points},
          {"experiment", experiment.text}};
}

std::string reportPage(const Results& results, const std::filesystem::path& folder,
                       const std::filesystem::path& assets) {
  Json data = toJson(results);
  data["metrics"] = metricsJson();
  data["pictures"] = picturesOf(results, folder);
  const std::string json = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  return reportPageOf(assets, "report", json,
                      {{"title", htmlSafe(results.experiment->title)},
                       {"interrupted", interruptedBanner(results.interrupted)}});
}

}  // namespace macula::experiment
