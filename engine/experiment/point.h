// One measured point: a JSON object, as a line of points.jsonl and in results.json. docs/report.md
// has its metrics.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/experiment/plan.h"
#include "engine/measure/frame_record.h"

namespace macula::experiment {

using Point = nlohmann::ordered_json;

/// How the numbers of a point came about.
inline constexpr const char* kMeasured = "measured";
inline constexpr const char* kOracle = "oracle";    ///< computed from all fragments; no time
inline constexpr const char* kRefused = "refused";  ///< "reason" says why

/// The keys of every point: where it stands in the experiment.
[[nodiscard]] Point startPoint(const Experiment& experiment, const Group& group, const Batch& batch,
                               const PointPlan& plan, std::string_view status);

/// A text of a point; empty where it has none.
[[nodiscard]] std::string textOf(const Point& point, const char* key);

/// Whether two points share study, scene, size, seed and light.
[[nodiscard]] bool sameGroup(const Point& a, const Point& b);

/// Whether the frames of two points were interleaved, so that their times may be divided by one
/// another.
[[nodiscard]] bool interleaved(const Point& a, const Point& b);

/// {"median", "p5", "p95"} of at least one value.
[[nodiscard]] Point spreadOf(std::span<const double> values);

/// Adds what was measured in the rounds of a point: metrics, spreads of times, passes, "rounds".
/// @param rounds at least one
void addRounds(Point& point, std::span<const measure::FrameRecord> rounds);

/// Names of all metrics: columns of results.csv that targets can use.
[[nodiscard]] std::vector<std::string> metricNames();

/// A number of a point by its metric's name ("ms.transparency" is the median; "ms.passes.NAME" that
/// of a pass); none where it does not apply.
[[nodiscard]] std::optional<double> metricOf(const Point& point, std::string_view metric);

/// results.csv: a header and one line a point. RFC 4180, lines end with "\n".
[[nodiscard]] std::string toCsv(std::span<const Point> points);

}  // namespace macula::experiment
