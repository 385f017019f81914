#include "engine/experiment/point.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "engine/measure/statistics.h"

namespace macula::experiment {
namespace {

/// A column of results.csv with a number.
struct Column {
  std::string name;
  Point::json_pointer place;  ///< in a point
};

std::vector<Column> makeColumns() {
  std::vector<Column> columns;
  for (const measure::Metric& metric : measure::kMetrics) {
    if (!metric.in(measure::kColumn) || !metric.isNumber()) continue;
    std::string place = "/" + std::string(metric.pointName());
    std::replace(place.begin(), place.end(), '.', '/');
    const std::string name(metric.columnName());
    if (!metric.spread) {
      columns.push_back({name, Point::json_pointer(place)});
      continue;
    }
    columns.push_back({name, Point::json_pointer(place + "/median")});
    for (const char* part : {"p5", "p95"}) {
      columns.push_back({name + "." + part, Point::json_pointer(place + "/" + part)});
    }
  }
  return columns;
}

const std::vector<Column>& columns() {
  static const std::vector<Column> all = makeColumns();
  return all;
}

constexpr std::string_view kPassPrefix = "ms.passes.";

/// Columns that say where a point stands, and are no numbers of it.
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

bool interleaved(const Point& a, const Point& b) {
  return textOf(a, "batch") == textOf(b, "batch");
}

Point spreadOf(std::span<const double> values) {
  constexpr double kLow = 0.05;
  return {{"median", measure::median(values).value()},
          {"p5", measure::percentile(values, kLow).value()},
          {"p95", measure::p95(values).value()}};
}

void addRounds(Point& point, std::span<const measure::FrameRecord> rounds) {
  measure::addTo(point, rounds.back(), measure::kPoint, measure::None::Group);
  for (std::size_t row = 0; row < measure::kMetrics.size(); ++row) {
    const measure::Metric& metric = measure::kMetrics[row];
    if (!metric.spread || !metric.in(measure::kPoint)) continue;
    std::vector<double> values;
    for (const measure::FrameRecord& round : rounds) values.push_back(round.number(row).value());
    const auto [parent, name] = measure::placeIn(point, metric.pointName());
    (*parent)[name] = spreadOf(values);
  }
  std::vector<std::pair<std::string, std::vector<double>>> passes;
  for (const measure::FrameRecord& round : rounds) {
    for (const auto& [name, ms] : round.passMs) {
      auto known = std::ranges::find(passes, name, &decltype(passes)::value_type::first);
      if (known == passes.end()) known = passes.insert(known, {name, {}});
      known->second.push_back(ms);
    }
  }
  point["ms"]["passes"] = Point::object();
  for (const auto& [name, ms] : passes) point["ms"]["passes"][name] = spreadOf(ms);
  point["rounds"] = rounds.size();
}

std::vector<std::string> metricNames() {
  std::vector<std::string> names;
  for (const Column& column : columns()) names.push_back(column.name);
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
    const auto found = std::ranges::find(columns(), metric, &Column::name);
    if (found == columns().end()) throw std::logic_error("a metric that was not checked");
    if (point.contains(found->place)) node = &point.at(found->place);
  }
  if (node == nullptr || !node->is_number()) return std::nullopt;
  return node->get<double>();
}

std::string toCsv(std::span<const Point> points) {
  const std::vector<std::string> passes = passNames(points);
  std::string csv;
  for (const char* name : kTexts) csv += std::string(csv.empty() ? "" : ",") + name;
  for (const Column& column : columns()) csv += "," + column.name;
  for (const std::string& name : passes) csv += "," + std::string(kPassPrefix) + name;
  csv += "\n";
  for (const Point& point : points) {
    std::string line;
    for (const char* name : kTexts) {
      if (name != kTexts[0]) line += ",";
      line += csvCell(point, name);
    }
    for (const Column& column : columns()) line += "," + numberCell(metricOf(point, column.name));
    for (const std::string& name : passes) {
      line += "," + numberCell(metricOf(point, std::string(kPassPrefix) + name));
    }
    csv += line + "\n";
  }
  return csv;
}

}  // namespace macula::experiment
