// What a row of the table of metrics says.
#pragma once

#include <cstdint>
#include <string_view>

namespace macula::measure {

enum class ValueType : std::uint8_t { Flag, Count, Number, Text };

enum class Better : std::uint8_t { Neither, Lower, Higher };

/// How the values of a run's frames become one entry of a summary.
enum class Summary : std::uint8_t {
  None,
  Sum,                 ///< none where a frame has no value
  Mean,                ///< of the frames that have a value
  MeanOfAll,           ///< none where a compared frame has no value: it would look like one of all
  RootMeanSquare,      ///< of the frames that have a value
  PsnrOfMeanSquare,    ///< 10 log10(1 / mean square) of error.rmse
  Largest,             ///< of the frames that have a value
  MedianAndP95,        ///< {"median", "p95"}
  MedianP95AndLargest  ///< {"frames", "median", "p95", "max"}, frames being those with a value
};

/// Where a metric is written; a sum of these.
enum Place : unsigned {
  kReport = 1,     ///< every frame of report.json
  kReportRun = 2,  ///< once in report.json, as the last frame had it
  kPoint = 4,      ///< a point of a chart's results.json
  kColumn = 8,     ///< a column of results.csv, which targets can use
  kPage = 16,      ///< the chart's report page: table, numbers of a point, choices of the axes
  kWalk = 32,      ///< the walk's panel of numbers and its --json
  kHold = 64,      ///< a column of hold's results.csv, and the summary of its results.json
  kEverywhere = kReport | kPoint | kColumn | kPage | kWalk | kHold,
};

struct Metric {
  /// Key in JSON, a dot for each level.
  std::string_view name;
  /// For people, in a table's heading or before a value.
  std::string_view title;
  /// "ms", "bytes", "fragments", ...; empty: none.
  std::string_view unit = {};
  ValueType type = ValueType::Number;
  Better better = Better::Neither;
  Summary summary = Summary::None;
  unsigned places = kEverywhere;
  /// Column of results.csv and word of a target, where it is not the name.
  std::string_view column = {};
  /// Key in a point of results.json, where it is not the name.
  std::string_view inPoint = {};
  /// Key in a summary, where it is not the name.
  std::string_view inSummary = {};
  /// Values that a text can have, split by spaces; empty: any.
  std::string_view words = {};
  /// In a point: median, 5th and 95th percentile over the rounds, in place of the last round's.
  bool spread = false;
  /// Sentences.
  std::string_view meaning;
  /// Where the value comes from.
  std::string_view source;
  /// Why there may be no value; empty: there always is one.
  std::string_view none = {};

  [[nodiscard]] constexpr bool in(unsigned place) const { return (places & place) != 0; }
  [[nodiscard]] constexpr bool isNumber() const {
    return type == ValueType::Count || type == ValueType::Number;
  }
  [[nodiscard]] constexpr std::string_view columnName() const {
    return column.empty() ? name : column;
  }
  [[nodiscard]] constexpr std::string_view pointName() const {
    return inPoint.empty() ? name : inPoint;
  }
  [[nodiscard]] constexpr std::string_view summaryName() const {
    return inSummary.empty() ? name : inSummary;
  }
};

}  // namespace macula::measure
