// The table of metrics: what its rows must be for all that is made from them.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/experiment/point.h"
#include "engine/measure/report_document.h"
#include "engine/measure/report_keys.h"
#include "engine/measure/report_schema.h"
#include "engine/measure/summary.h"

namespace macula::measure {
namespace {

using Json = nlohmann::ordered_json;

TEST(Metrics, EveryRowIsComplete) {
  std::set<std::string_view> names;
  std::set<std::string_view> columns;
  for (const Metric& metric : kMetrics) {
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name << " stands twice";
    if (metric.in(kColumn)) {
      EXPECT_TRUE(columns.insert(metric.columnName()).second) << metric.columnName();
    }
    EXPECT_NE(metric.title, "") << metric.name;
    EXPECT_TRUE(metric.meaning.ends_with('.')) << metric.name;
    EXPECT_NE(metric.source, "") << metric.name;
    EXPECT_NE(metric.places, 0U) << metric.name;
    EXPECT_TRUE(metric.type == ValueType::Text || metric.words.empty()) << metric.name;
  }
}

TEST(Metrics, LockFailuresAreEverywhere) {
  const auto* const row = std::ranges::find(kMetrics, "lock_failures", &Metric::name);
  ASSERT_NE(row, kMetrics.end());
  EXPECT_EQ(row->places, unsigned{kEverywhere});
  const std::vector<std::string> columns = experiment::metricNames();
  EXPECT_EQ(std::ranges::count(columns, "lock_failures"), 1);
  EXPECT_TRUE(summaryOf({}, kHold).contains("lock_failures"));
}

TEST(Metrics, ARecordTakesTheTypeOfItsRow) {
  FrameRecord record;
  record.set("k.mean", 2.5F);
  record.set("exact", true);
  EXPECT_EQ(record.number("k.mean"), 2.5);
  EXPECT_EQ(record.number("k.max"), std::nullopt);
  EXPECT_THROW(record.set("k.mean", 2U), std::logic_error);
  EXPECT_THROW(record.set("k.max", 2.0), std::logic_error);
  EXPECT_THROW(record.set("exact", "yes"), std::logic_error);
}

TEST(Metrics, LevelsWithoutAnyValueAreOneNullOrNothing) {
  FrameRecord record;
  record.set("k.max", 3U);
  Json grouped = Json::object();
  addTo(grouped, record, kWalk, None::Group);
  EXPECT_TRUE(grouped["fragments"].is_null());
  EXPECT_EQ(grouped["k"].dump(), R"({"min":null,"max":3,"mean":null})");
  EXPECT_TRUE(grouped["deepest"].is_null());
  Json omitted = Json::object();
  addTo(omitted, record, kWalk, None::Omit);
  EXPECT_EQ(omitted.dump(), R"({"k":{"min":null,"max":3,"mean":null}})");
}

TEST(Metrics, RoundsOfAPointAreSpreads) {
  std::vector<FrameRecord> rounds(3);
  for (const double ms : {3.0, 1.0, 2.0}) {
    FrameRecord& round = rounds[static_cast<std::size_t>(ms) - 1];
    for (const MetricId id :
         {MetricId("ms.total"), MetricId("ms.transparency"), MetricId("ms.shading")}) {
      round.set(id, ms);
    }
    round.passMs = {{"tonemap", ms / 2}};
  }
  rounds.back().set("bytes.total", std::uint64_t{5});
  experiment::Point point = Json::object();
  experiment::addRounds(point, rounds);
  EXPECT_EQ(point["ms"]["total"]["median"], 2.0);
  EXPECT_EQ(point["ms"]["passes"]["tonemap"]["median"], 1.0);
  EXPECT_EQ(point["bytes"]["transparency"], 5);
  EXPECT_EQ(experiment::metricOf(point, "bytes.transparency"), 5.0);
  EXPECT_EQ(experiment::metricOf(point, "ms.total"), 2.0);
  EXPECT_TRUE(point["error"].is_null());
}

/// Whether every object of a schema is closed or a map of typed values.
bool isStrict(const Json& schema) {
  if (schema.contains("properties")) {
    if (!schema.contains("additionalProperties")) return false;
    for (const auto& [name, property] : schema["properties"].items()) {
      if (!isStrict(property)) return false;
    }
  }
  return !schema.contains("items") || isStrict(schema["items"]);
}

TEST(ReportSchema, IsClosedAndKnowsEveryKey) {
  const Json schema = reportSchema();
  EXPECT_TRUE(isStrict(schema));
  EXPECT_TRUE(isStrict(schema["$defs"]["input"]));
  EXPECT_EQ(schema["additionalProperties"], false);
  const Json& frame = schema["properties"]["frames"]["items"];
  EXPECT_EQ(frame["properties"]["fragments"]["properties"]["lost"]["type"].dump(),
            R"(["integer","null"])");
  EXPECT_EQ(frame["properties"]["lock_failures"]["type"], "integer");
  EXPECT_EQ(frame["required"].size(), frame["properties"].size());
  const Json& optional = schema["required"];
  EXPECT_EQ(std::ranges::count(optional, "recording"), 0);
  EXPECT_EQ(std::ranges::count(optional, "gaze_log"), 1);
}

TEST(ReportDocument, NamesEveryMetricAndKey) {
  const std::string page = reportDocument();
  const auto names = [&](std::string_view name) {
    return page.find("| `" + std::string(name) + "` |") != std::string::npos;
  };
  for (const Metric& metric : kMetrics) EXPECT_TRUE(names(metric.name)) << metric.name;
  for (const ReportKey& key : kReportKeys) EXPECT_TRUE(names(key.name)) << key.name;
}

}  // namespace
}  // namespace macula::measure
