#include "engine/measure/run_record.h"

#include <algorithm>
#include <cmath>

#include "engine/measure/statistics.h"

namespace macula::measure {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no NaN and no infinity: both mean that there is no such value.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

template <typename T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json errorJson(const std::optional<ImageError>& error) {
  if (!error) {
    return {{"rmse", nullptr},
            {"psnr_db", nullptr},
            {"max", nullptr},
            {"flip", nullptr},
            {"flip_gaze", nullptr}};
  }
  return {{"rmse", error->rmse},
          {"psnr_db", orNull(error->psnrDb)},
          {"max", error->max},
          {"flip", orNull(error->flip)},
          {"flip_gaze", orNull(error->flipGaze)}};
}

Json fragmentsJson(const std::optional<FragmentNumbers>& f) {
  if (!f) {
    return {{"generated", nullptr}, {"stored", nullptr}, {"merged", nullptr}, {"lost", nullptr}};
  }
  return {
      {"generated", f->generated}, {"stored", f->stored}, {"merged", f->merged}, {"lost", f->lost}};
}

Json shadingJson(const std::optional<ShadingNumbers>& s) {
  if (!s) return {{"pixels", nullptr}, {"shaded", nullptr}, {"holes", nullptr}};
  return {{"pixels", s->pixels}, {"shaded", s->shaded}, {"holes", s->holes}};
}

Json layersJson(const std::optional<LayerNumbers>& k) {
  if (!k) return {{"min", nullptr}, {"max", nullptr}, {"mean", nullptr}};
  return {{"min", k->min}, {"max", k->max}, {"mean", k->mean}};
}

Json frameJson(const FrameRecord& frame) {
  Json ms{{"total", frame.totalMs}};
  for (const auto& [name, value] : frame.passMs) ms[name] = value;
  return {{"index", frame.index},
          {"time_s", frame.timeSeconds},
          {"gaze",
           {{"x", frame.gazeX},
            {"y", frame.gazeY},
            {"raw_x", number(frame.rawX)},
            {"raw_y", number(frame.rawY)},
            {"state", frame.gazeState},
            {"age_s", number(frame.gazeAgeSeconds)}}},
          {"fovea",
           {{"radius", frame.gazeRadius},
            {"saccade", frame.gazeSaccade},
            {"error_deg", orNull(frame.gazeErrorDegrees)}}},
          {"r", frame.resizeFactor},
          {"shading", shadingJson(frame.shading)},
          {"ms", ms},
          {"fragments", fragmentsJson(frame.fragments)},
          {"k", layersJson(frame.layers)},
          {"error", errorJson(frame.error)},
          {"flicker", orNull(frame.flicker)},
          {"hazards", orNull(frame.hazards)},
          {"exact", frame.exact},
          {"image_sha256", frame.imageSha256}};
}

std::optional<ImageError> meanError(const std::vector<FrameRecord>& frames) {
  ImageError sum;
  std::vector<double> squares;
  std::vector<double> flips;
  std::vector<double> gazeFlips;
  for (const FrameRecord& frame : frames) {
    if (!frame.error) continue;
    squares.push_back(frame.error->rmse * frame.error->rmse);
    sum.max = std::max(sum.max, frame.error->max);
    if (frame.error->flip) flips.push_back(*frame.error->flip);
    if (frame.error->flipGaze) gazeFlips.push_back(*frame.error->flipGaze);
  }
  const std::optional<double> meanSquare = mean(squares);
  if (!meanSquare) return std::nullopt;
  sum.rmse = std::sqrt(*meanSquare);
  if (*meanSquare > 0.0) sum.psnrDb = -10.0 * std::log10(*meanSquare);
  // A mean over some of the frames would look like one over all.
  if (flips.size() == squares.size()) sum.flip = mean(flips);
  if (gazeFlips.size() == squares.size()) sum.flipGaze = mean(gazeFlips);
  return sum;
}

std::optional<FragmentNumbers> sumFragments(const std::vector<FrameRecord>& frames) {
  FragmentNumbers sum;
  for (const FrameRecord& frame : frames) {
    if (!frame.fragments) return std::nullopt;
    sum.generated += frame.fragments->generated;
    sum.stored += frame.fragments->stored;
    sum.merged += frame.fragments->merged;
    sum.lost += frame.fragments->lost;
  }
  return sum;
}

Json gazeErrorJson(const std::vector<FrameRecord>& frames) {
  std::vector<double> errors;
  for (const FrameRecord& frame : frames) {
    if (frame.gazeErrorDegrees) errors.push_back(*frame.gazeErrorDegrees);
  }
  return {{"frames", errors.size()},
          {"median", orNull(median(errors))},
          {"p95", orNull(p95(errors))},
          {"max", errors.empty() ? Json(nullptr) : Json(*std::ranges::max_element(errors))}};
}

Json summaryJson(const RunRecord& run) {
  std::vector<double> totals;
  std::vector<double> flickers;
  for (const FrameRecord& frame : run.frames) {
    totals.push_back(frame.totalMs);
    if (frame.flicker) flickers.push_back(*frame.flicker);
  }
  return {{"ms", {{"median", orNull(median(totals))}, {"p95", orNull(p95(totals))}}},
          {"error", errorJson(meanError(run.frames))},
          {"flicker", orNull(mean(flickers))},
          {"gaze_error_deg", gazeErrorJson(run.frames)},
          {"fragments", fragmentsJson(sumFragments(run.frames))},
          {"load_ms", run.loadMs},
          {"first_frame_ms", run.firstFrameMs}};
}

}  // namespace

Json toJson(const RunRecord& run) {
  Json buffers = Json::object();
  for (const auto& [name, bytes] : run.transparencyBytes) buffers[name] = bytes;
  Json report{
      {"schema", 1},
      {"commit", run.commit},
      {"scene", run.scene},
      {"width", run.width},
      {"height", run.height},
      {"gl",
       {{"renderer", run.renderer}, {"version", run.version}, {"time_source", run.timeSource}}},
      {"method", run.method},
      {"sync", orNull(run.sync)},
      {"settings", Json(run.settings)},
      {"provenance", run.provenance},
      {"bytes",
       {{"oit", run.oitBytes},
        {"budget", orNull(run.budgetBytes)},
        {"overhead", run.overheadBytes},
        {"gbuffer", run.gbufferBytes},
        {"buffers", buffers}}},
      {"interrupted", run.interrupted},
      {"frames", Json::array()}};
  for (const FrameRecord& frame : run.frames) report["frames"].push_back(frameJson(frame));
  report["summary"] = summaryJson(run);
  return report;
}

}  // namespace macula::measure
