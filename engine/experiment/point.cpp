#include "engine/experiment/point.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "engine/measure/statistics.h"

namespace macula::experiment {
namespace {

struct Metric {
  const char* name;
  const char* pointer;  ///< where it stands in a point (RFC 6901)
};

constexpr Metric kMetrics[] = {
    {"ms.transparency", "/ms/transparency/median"},
    {"ms.transparency.p5", "/ms/transparency/p5"},
    {"ms.transparency.p95", "/ms/transparency/p95"},
    {"ms.shading", "/ms/shading/median"},
    {"ms.shading.p5", "/ms/shading/p5"},
    {"ms.shading.p95", "/ms/shading/p95"},
    {"ms.total", "/ms/total/median"},
    {"ms.total.p5", "/ms/total/p5"},
    {"ms.total.p95", "/ms/total/p95"},
    {"speedup", "/speedup"},
    {"shading.shaded_share", "/shading/shaded_share"},
    {"shading.holes_share", "/shading/holes_share"},
    {"bytes.transparency", "/bytes/transparency"},
    {"bytes.oit", "/bytes/oit"},
    {"bytes.budget", "/bytes/budget"},
    {"bytes.overhead", "/bytes/overhead"},
    {"bytes.gbuffer", "/bytes/gbuffer"},
    {"budget_used", "/budget_used"},
    {"fragments.generated", "/fragments/generated"},
    {"fragments.stored", "/fragments/stored"},
    {"fragments.merged", "/fragments/merged"},
    {"fragments.lost", "/fragments/lost"},
    {"fragments.loss", "/fragments/loss"},
    {"k.min", "/k/min"},
    {"k.max", "/k/max"},
    {"k.mean", "/k/mean"},
    {"deepest", "/deepest"},
    {"rmse", "/error/rmse"},
    {"psnr_db", "/error/psnr_db"},
    {"max", "/error/max"},
    {"flip", "/error/flip"},
    {"flip_gaze", "/error/flip_gaze"},
    {"flicker", "/path/flicker"},
    {"path_rmse", "/path/rmse"},
};

constexpr std::string_view kPassPrefix = "ms.passes.";

/// Columns that are no metrics.
constexpr const char* kTexts[] = {"study",  "scene",   "width", "height", "seed",
                                  "light",  "variant", "label", "budget", "sweep",
                                  "status", "reason",  "sync",  "exact",  "key"};

std::string csvCell(const Point& point, const char* key) {
  const auto found = point.find(key);
  if (found == point.end() || found->is_null()) return "";
  const std::string text = found->is_string() ? found->get<std::string>() : found->dump();
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

/// The shortest text that reads back as the same number.
std::string numberCell(const std::optional<double>& number) {
  if (!number) return "";
  char text[32];
  const auto end = std::to_chars(text, text + sizeof(text), *number);
  return {text, end.ptr};
}

std::vector<std::string> passNames(std::span<const Point> points) {
  std::vector<std::string> names;
  for (const Point& point : points) {
    const auto passes = Point::json_pointer("/ms/passes");
    if (!point.contains(passes)) continue;
    for (const auto& [name, spread] : point.at(passes).items()) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

}  // namespace

Point startPoint(const Experiment& experiment, const Group& group, const Batch& batch,
                 const PointPlan& plan, std::string_view status) {
  const Variant& variant = experiment.variants[plan.variant];
  return {{"key", plan.key},
          {"batch", batch.key()},
          {"study", experiment.studies[group.study].id},
          {"scene", group.scene},
          {"width", group.size.width},
          {"height", group.size.height},
          {"seed", group.seed},
          {"light", group.light},
          {"variant", variant.id},
          {"label", variant.labelAt(plan.value)},
          {"budget", plan.budget ? Point(plan.budget->label()) : Point(nullptr)},
          {"sweep", plan.value ? Point(*plan.value) : Point(nullptr)},
          {"status", status}};
}

std::string textOf(const Point& point, const char* key) {
  const auto found = point.find(key);
  return found != point.end() && found->is_string() ? found->get<std::string>() : "";
}

bool sameGroup(const Point& a, const Point& b) {
  return a["study"] == b["study"] && a["scene"] == b["scene"] && a["width"] == b["width"] &&
         a["height"] == b["height"] && a["seed"] == b["seed"] && a["light"] == b["light"];
}

bool tookTurns(const Point& a, const Point& b) {
  return textOf(a, "batch") == textOf(b, "batch");
}

Point spreadOf(std::span<const double> values) {
  constexpr double kLow = 0.05;
  return {{"median", measure::median(values).value()},
          {"p5", measure::percentile(values, kLow).value()},
          {"p95", measure::p95(values).value()}};
}

std::vector<std::string> metricNames() {
  std::vector<std::string> names;
  for (const Metric& metric : kMetrics) names.emplace_back(metric.name);
  return names;
}

std::optional<double> metricOf(const Point& point, std::string_view metric) {
  const Point* node = nullptr;
  if (metric.starts_with(kPassPrefix)) {
    const auto passes = Point::json_pointer("/ms/passes");
    const std::string name(metric.substr(kPassPrefix.size()));
    if (point.contains(passes) && point.at(passes).contains(name)) {
      node = &point.at(passes).at(name).at("median");
    }
  } else {
    const auto found = std::find_if(std::begin(kMetrics), std::end(kMetrics),
                                    [&](const Metric& m) { return metric == m.name; });
    if (found == std::end(kMetrics)) throw std::logic_error("a metric that was not checked");
    const Point::json_pointer pointer(found->pointer);
    if (point.contains(pointer)) node = &point.at(pointer);
  }
  if (node == nullptr || !node->is_number()) return std::nullopt;
  return node->get<double>();
}

std::string toCsv(std::span<const Point> points) {
  const std::vector<std::string> passes = passNames(points);
  std::string csv;
  for (const char* name : kTexts) csv += std::string(csv.empty() ? "" : ",") + name;
  for (const Metric& metric : kMetrics) csv += std::string(",") + metric.name;
  for (const std::string& name : passes) csv += "," + std::string(kPassPrefix) + name;
  csv += "\n";
  for (const Point& point : points) {
    std::string line;
    for (const char* name : kTexts) {
      if (name != kTexts[0]) line += ",";
      line += csvCell(point, name);
    }
    for (const Metric& metric : kMetrics) line += "," + numberCell(metricOf(point, metric.name));
    for (const std::string& name : passes) {
      line += "," + numberCell(metricOf(point, std::string(kPassPrefix) + name));
    }
    csv += line + "\n";
  }
  return csv;
}

}  // namespace macula::experiment
