#include "hold_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/core/plural.h"
#include "engine/measure/summary.h"
#include "macula_version.h"

namespace macula::tools {

using nlohmann::ordered_json;

namespace {

constexpr double kPercent = 100.0;

/// Thousandths are finer than any difference that matters, and keep the page small.
double rounded(double value) {
  return std::round(value * 1e3) / 1e3;
}

template <typename T>
ordered_json orNull(const std::optional<T>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json partJson(const control::HoldPart& part, bool controlled) {
  return {{"begin", part.begin},
          {"end", part.end},
          {"load", part.load},
          {"ideal_r", part.model.idealResize},
          {"reachable_ms", part.model.reachableMs},
          {"judged_frames", part.judged},
          {"within", part.within},
          {"met", controlled ? orNull(part.met) : ordered_json(nullptr)},
          {"settle_frames", orNull(part.settleFrames)},
          {"used_pixels", orNull(part.usedPixels)}};
}

ordered_json measuresJson(const control::HoldMeasures& m) {
  return {{"judged_frames", m.judged},
          {"within_5", m.withinFive},
          {"within_tolerance", m.withinTolerance},
          {"over_102_share", m.over102},
          {"over_110_share", m.over110},
          {"longest_over", m.longestOver},
          {"p50_ms", m.p50Ms},
          {"p95_ms", m.p95Ms},
          {"p99_ms", m.p99Ms},
          {"sigma_ms", m.sigmaMs},
          {"bias_ms", m.biasMs},
          {"changes_per_100", m.changes},
          {"reversals_per_100", m.reversals}};
}

/// Whether anything was controlled, so that there is something to judge.
bool isControlled(const HoldRecord& record, const HoldOptions& options) {
  return record.clockFault.empty() && options.control.law != "off";
}

/// What is said of the whole, and why it is not judged.
struct Verdict {
  std::string word;
  std::string reason;
};

Verdict verdictOf(const HoldRecord& record, const HoldOptions& options) {
  if (!record.clockFault.empty()) return {"not judged", record.clockFault};
  if (!isControlled(record, options)) return {"not judged", "nothing is controlled"};
  std::string word = control::verdictOf(record.measures);
  return {word, record.measures.judged == 0 ? "every frame settles" : ""};
}

double fullRateOf(const HoldRecord& record, int times) {
  return std::ranges::find(record.loads, times, &LoadTimes::times)->fullRateMs;
}

/// The least time that r reaches.
double leastOf(const HoldRecord& record, const control::HoldLoad& load, double most) {
  return std::min(fullRateOf(record, load.times),
                  load.model.workMs / (most * most) + load.model.restMs);
}

/// Names of all passes, in the order in which they came first.
std::vector<std::string> passNames(std::span<const measure::FrameRecord> records) {
  std::vector<std::string> names;
  for (const measure::FrameRecord& record : records) {
    for (const auto& [name, ms] : record.passMs) {
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

/// A comma and the value, as JSON has it; nothing behind the comma where there is none.
std::string cellOf(const measure::Value& value) {
  return value.index() == 0 ? "," : "," + measure::toJson(value).dump();
}

}  // namespace

ordered_json toJson(const HoldRecord& record, const HoldOptions& options) {
  const control::HoldMeasures& m = record.measures;
  const bool controlled = isControlled(record, options);
  const Verdict verdict = verdictOf(record, options);
  ordered_json json{{"schema", 1},
                    {"commit", MACULA_COMMIT},
                    {"scene", options.scene},
                    {"width", record.size.x},
                    {"height", record.size.y},
                    {"gl", {{"renderer", record.glRenderer}, {"version", record.glVersion}}},
                    {"time_source", record.timeSource},
                    {"clock_fault", nullptr},
                    {"law", options.control.law},
                    {"target_ms", record.targetMs},
                    {"target_share", nullptr},
                    {"interrupted", !record.interrupted.empty()},
                    {"frames", record.held.size()},
                    {"settings", options.registry.toJson()},
                    {"provenance", record.provenance}};
  json["gaze_log"] = record.gazeLog;
  if (!record.clockFault.empty()) json["clock_fault"] = record.clockFault;
  if (options.targetShare) json["target_share"] = *options.targetShare;
  json["loads"] = ordered_json::array();
  for (const control::HoldLoad& load : m.loads) {
    const double most = options.control.mostResize;
    json["loads"].push_back({{"times", load.times},
                             {"full_rate_ms", fullRateOf(record, load.times)},
                             {"work_ms", load.model.workMs},
                             {"rest_ms", load.model.restMs},
                             {"ideal_r", load.model.idealResize},
                             {"limit", control::textOf(load.model.limit, most)},
                             {"least_ms", leastOf(record, load, most)}});
  }
  json["steps"] = ordered_json::array();
  for (const LoadStep& step : record.steps) {
    json["steps"].push_back({{"frame", step.frame}, {"times", step.times}});
  }
  json["gate"] = {{"tolerance", m.tolerance},
                  {"share", control::kGateShare},
                  {"within", m.withinTolerance},
                  {"met", controlled ? orNull(m.met) : ordered_json(nullptr)}};
  json["verdict"] = verdict.word;
  json["reason"] = verdict.reason.empty() ? ordered_json(nullptr) : ordered_json(verdict.reason);
  json["held"] = measuresJson(m);
  json["summary"] = measure::summaryOf(record.records, measure::kHold);
  json["fixed"] = {
      {"r", record.fixedResize}, {"spread", m.fixedSpread}, {"within_tolerance", m.fixedWithin}};
  json["parts"] = ordered_json::array();
  for (const control::HoldPart& part : m.parts) {
    json["parts"].push_back(partJson(part, controlled));
  }
  json["notices"] = ordered_json::array();
  for (const HoldNotice& notice : record.notices) {
    json["notices"].push_back({{"frame", notice.frame}, {"text", notice.text}});
  }
  return json;
}

std::string toCsv(const HoldRecord& record) {
  const std::vector<std::string> passes = passNames(record.records);
  std::string csv =
      "frame,time_s,load,r,lever_resize,fovea_slope,layer_share,ms,resizable_ms,fixed_r_ms";
  for (const measure::Metric& metric : measure::kMetrics) {
    if (metric.in(measure::kHold)) csv += fmt::format(",{}", metric.columnName());
  }
  for (const std::string& name : passes) csv += fmt::format(",ms.{}", name);
  csv += "\n";
  for (std::size_t i = 0; i < record.held.size(); ++i) {
    const control::HeldFrame& held = record.held[i];
    const HoldFrame& frame = record.frames[i];
    const measure::FrameRecord& numbers = record.records[i];
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{}", i, frame.timeSeconds, held.load,
                       held.resize, frame.controls.resize, frame.controls.foveaSlope,
                       frame.controls.layerShare, held.ms, held.resizableMs, held.fixedMs);
    for (std::size_t row = 0; row < measure::kMetrics.size(); ++row) {
      if (measure::kMetrics[row].in(measure::kHold)) csv += cellOf(numbers.at(row));
    }
    for (const std::string& name : passes) {
      const auto pass =
          std::ranges::find(numbers.passMs, name, [](const auto& p) { return p.first; });
      csv += pass == numbers.passMs.end() ? "," : fmt::format(",{}", pass->second);
    }
    csv += "\n";
  }
  return csv;
}

ordered_json pageData(const HoldRecord& record, const HoldOptions& options) {
  ordered_json data = toJson(record, options);
  data.erase("settings");
  ordered_json trace{{"ms", ordered_json::array()},
                     {"fixed_ms", ordered_json::array()},
                     {"r", ordered_json::array()},
                     {"fovea_slope", ordered_json::array()},
                     {"layer_share", ordered_json::array()}};
  for (std::size_t i = 0; i < record.held.size(); ++i) {
    trace["ms"].push_back(rounded(record.held[i].ms));
    trace["fixed_ms"].push_back(rounded(record.held[i].fixedMs));
    trace["r"].push_back(rounded(record.held[i].resize));
    trace["fovea_slope"].push_back(
        rounded(static_cast<double>(record.frames[i].controls.foveaSlope)));
    trace["layer_share"].push_back(
        rounded(static_cast<double>(record.frames[i].controls.layerShare)));
  }
  data["trace"] = trace;
  return data;
}

std::string summaryOf(const HoldRecord& record, const HoldOptions& options) {
  const control::HoldMeasures& m = record.measures;
  const bool controlled = isControlled(record, options);
  std::string text;
  for (const control::HoldLoad& load : m.loads) {
    const double most = options.control.mostResize;
    text += fmt::format(
        "load {}: full rate {:.2f} ms; at r: {:.2f} / r^2 + {:.2f} ms; least {:.2f} ms; ideal r "
        "{:.2f} ({})\n",
        load.times, fullRateOf(record, load.times), load.model.workMs, load.model.restMs,
        leastOf(record, load, most), load.model.idealResize,
        control::textOf(load.model.limit, most));
  }
  text += fmt::format("target {:.2f} ms by {}: median {:.2f}, p95 {:.2f}, p99 {:.2f} ms\n",
                      record.targetMs, options.control.law, m.p50Ms, m.p95Ms, m.p99Ms);
  for (const control::HoldPart& part : m.parts) {
    text += fmt::format("frames {} to {}, load {}: ", part.begin, part.end - 1, part.load);
    if (controlled && part.met) {
      text += fmt::format("{} ({:.1f} % within); ", *part.met ? "held" : "not held",
                          kPercent * part.within);
    }
    text += part.settleFrames ? fmt::format("settled in frame {}", part.begin + *part.settleFrames)
                              : std::string("never settled");
    text += part.usedPixels
                ? fmt::format("; {:.1f} % of the ideal's pixels\n", kPercent * *part.usedPixels)
                : std::string("; too short to be judged\n");
  }
  text += fmt::format("over 1.02 T {:.1f} %, over 1.1 T {:.1f} %, at most {} in a row\n",
                      kPercent * m.over102, kPercent * m.over110, m.longestOver);
  text += fmt::format("fixed r {:.2f}: spread {:.1f} %, {:.1f} % of its frames within {:.1f} %\n",
                      record.fixedResize, kPercent * m.fixedSpread, kPercent * m.fixedWithin,
                      kPercent * m.tolerance);
  for (const HoldNotice& notice : record.notices) {
    text += fmt::format("frame {}: {}\n", notice.frame,
                        notice.text.empty() ? "nothing any more" : notice.text);
  }
  const Verdict verdict = verdictOf(record, options);
  text += fmt::format(
      "within {:.1f} %, which is 5 % and the spread or {:.0f} %: {:.1f} % of {} (to reach: "
      "{:.0f} %): {}{}\n",
      kPercent * m.tolerance, kPercent * control::kMostTolerance, kPercent * m.withinTolerance,
      counted(m.judged, "frame"), kPercent * control::kGateShare, verdict.word,
      verdict.reason.empty() ? "" : ", for " + verdict.reason);
  return text;
}

}  // namespace macula::tools
