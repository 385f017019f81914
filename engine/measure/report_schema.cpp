#include "engine/measure/report_schema.h"

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "engine/measure/metrics.h"
#include "engine/measure/report_keys.h"

namespace macula::measure {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSha256 = "^[0-9a-f]{64}$";

Json closedObject() {
  return {{"type", "object"},
          {"properties", Json::object()},
          {"required", Json::array()},
          {"additionalProperties", false}};
}

Json mapOf(const Json& values) {
  return {{"type", "object"}, {"additionalProperties", values}};
}

/// Adds a key of several levels to an object's schema; levels that are missing are closed objects.
void add(Json& object, std::string_view key, const Json& schema, bool required = true) {
  const std::size_t dot = key.find('.');
  const std::string name(key.substr(0, dot));
  Json& property = object["properties"][name];
  const bool isNew = property.is_null();
  if (dot == std::string_view::npos) {
    property = schema;
  } else if (isNew) {
    property = closedObject();
  }
  if (isNew && required) object["required"].push_back(name);
  if (dot != std::string_view::npos) add(property, key.substr(dot + 1), schema, required);
}

Json orNull(Json schema) {
  schema["type"] = Json::array({schema["type"], "null"});
  if (schema.contains("enum")) schema["enum"].push_back(nullptr);
  return schema;
}

Json countSchema() {
  return {{"type", "integer"}, {"minimum", 0}};
}

Json textSchema(std::string_view words) {
  Json schema{{"type", "string"}};
  std::istringstream in{std::string(words)};
  for (std::string word; in >> word;) schema["enum"].push_back(word);
  return schema;
}

Json schemaOf(ValueType type, std::string_view words) {
  switch (type) {
    case ValueType::Flag:
      return {{"type", "boolean"}};
    case ValueType::Count:
      return countSchema();
    case ValueType::Number:
      return {{"type", "number"}};
    case ValueType::Text:
      break;
  }
  return textSchema(words);
}

Json reference(const char* name) {
  return {{"$ref", std::string("#/$defs/") + name}};
}

Json schemaOf(const ReportKey& key) {
  switch (key.shape) {
    case Shape::Flag:
      return {{"type", "boolean"}};
    case Shape::Count:
      return countSchema();
    case Shape::Integer:
      return {{"type", "integer"}};
    case Shape::Number:
      return {{"type", "number"}};
    case Shape::Text:
      return textSchema(key.words);
    case Shape::Texts:
      return {{"type", "array"}, {"items", {{"type", "string"}}}};
    case Shape::Input:
      return reference("input");
    case Shape::Inputs:
      return mapOf(reference("input"));
    case Shape::Settings:
      return mapOf({{"type", {"boolean", "number", "string", "array"}}});
    case Shape::Counts:
      return mapOf(countSchema());
    case Shape::Group:
      break;
  }
  return closedObject();
}

std::string describe(std::string_view meaning, std::string_view unit, std::string_view none,
                     Better better = Better::Neither) {
  std::string text(meaning);
  if (!unit.empty()) text += " Unit: " + std::string(unit) + ".";
  if (better == Better::Lower) text += " Lower is better.";
  if (better == Better::Higher) text += " Higher is better.";
  if (!none.empty()) text += " Null: " + std::string(none) + ".";
  return text;
}

void addMetric(Json& object, const Metric& metric) {
  Json schema = schemaOf(metric.type, metric.words);
  if (metric.name == "image_sha256") schema["pattern"] = kSha256;
  if (!metric.none.empty()) schema = orNull(std::move(schema));
  schema["description"] = describe(metric.meaning, metric.unit, metric.none, metric.better);
  add(object, metric.name, schema);
}

Json frameSchema() {
  Json frame = closedObject();
  for (const Metric& metric : kMetrics) {
    if (metric.in(kReport)) addMetric(frame, metric);
  }
  frame["properties"]["ms"]["additionalProperties"] = {
      {"type", "number"}, {"description", "Time of the pass of that name. Unit: ms."}};
  return frame;
}

Json summarySchema(const Metric& metric) {
  const Json number{{"type", {"number", "null"}}};
  const auto numbers = [&](std::initializer_list<const char*> names) {
    Json object = closedObject();
    for (const char* name : names) add(object, name, number);
    return object;
  };
  switch (metric.summary) {
    case Summary::Sum:
      return orNull(countSchema());
    case Summary::MedianAndP95:
      return numbers({"median", "p95"});
    case Summary::MedianP95AndLargest: {
      Json object = closedObject();
      add(object, "frames", countSchema());
      for (const char* name : {"median", "p95", "max"}) add(object, name, number);
      return object;
    }
    default:
      return number;
  }
}

Json inputSchema() {
  const Json hash = orNull({{"type", "string"}, {"pattern", kSha256}});
  Json file = closedObject();
  add(file, "path", {{"type", "string"}});
  add(file, "sha256", hash);
  Json input = closedObject();
  add(input, "name", {{"type", "string"}});
  add(input, "path", {{"type", {"string", "null"}}});
  add(input, "sha256", hash);
  add(input, "files", {{"type", "array"}, {"items", file}});
  return input;
}

}  // namespace

Json reportSchema() {
  Json report = closedObject();
  // In the order of the file: frames and summary stand between the rows of the run.
  for (const Metric& metric : kMetrics) {
    if (metric.in(kReportRun)) addMetric(report, metric);
  }
  add(report, "frames", {{"type", "array"}, {"items", frameSchema()}});
  for (const Metric& metric : kMetrics) {
    if (!metric.in(kReport) || metric.summary == Summary::None) continue;
    add(report, "summary." + std::string(metric.summaryName()), summarySchema(metric));
  }
  for (const ReportKey& key : kReportKeys) {
    Json schema = schemaOf(key);
    if (!key.none.empty()) schema = orNull(std::move(schema));
    schema["description"] = describe(key.meaning, key.unit, key.none);
    add(report, key.name, schema, key.absent.empty());
  }
  report["properties"]["schema"]["const"] = 1;
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "report.json of macula replay"}};
  schema.update(report);
  schema["$defs"]["input"] = inputSchema();
  return schema;
}

}  // namespace macula::measure
