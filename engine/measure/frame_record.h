// What was measured of one frame: a value for each row of the table of metrics.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/measure/image_error.h"
#include "engine/measure/metrics.h"

namespace macula::measure {

/// Names a row of the table by its metric's name; a name that is not there does not compile.
struct MetricId {
  std::size_t row = 0;
  consteval MetricId(const char* name) {  // NOLINT(google-explicit-constructor): reads as a name
    while (row < kMetrics.size() && kMetrics[row].name != name) ++row;
    if (row == kMetrics.size()) throw std::logic_error("no such metric");
  }
};

/// None, or a value of the row's type.
using Value = std::variant<std::monostate, bool, std::uint64_t, double, std::string>;

class FrameRecord {
 public:
  /// A number that is not finite is none.
  /// @throws std::logic_error where the row is of another type
  template <typename T>
  void set(MetricId metric, const T& value) {
    if constexpr (std::same_as<T, bool>) {
      put(metric.row, value);
    } else if constexpr (std::unsigned_integral<T>) {
      put(metric.row, std::uint64_t{value});
    } else if constexpr (std::floating_point<T>) {
      put(metric.row, double{value});
    } else {
      put(metric.row, std::string(value));
    }
  }
  template <typename T>
  void set(MetricId metric, const std::optional<T>& value) {
    if (value) set(metric, *value);
  }

  [[nodiscard]] const Value& at(std::size_t row) const { return values_[row]; }
  /// A count or a number; none where there is none.
  [[nodiscard]] std::optional<double> number(std::size_t row) const;
  [[nodiscard]] std::optional<double> number(MetricId metric) const { return number(metric.row); }

  /// Milliseconds of each pass, in the order in which they ran.
  std::vector<std::pair<std::string, double>> passMs;

 private:
  void put(std::size_t row, Value value);

  std::array<Value, kMetrics.size()> values_;
};

/// Sets the metrics error.*.
void setError(FrameRecord& record, const ImageError& error);

/// What stands for a metric without a value.
enum class None : std::uint8_t {
  Null,   ///< null
  Group,  ///< null, and one null for a level of keys without any value
  Omit,   ///< nothing; null beside a value of the same level
};

/// Adds the record's metrics of some places to an object, a level of keys for each dot.
/// @param places a sum of Place. Of kPoint, the keys are those of a point, and metrics with a
/// spread
///   over rounds are left out.
void addTo(nlohmann::ordered_json& object, const FrameRecord& record, unsigned places, None none);

[[nodiscard]] nlohmann::ordered_json toJson(const Value& value);

/// The object that holds a key of several levels, "fragments.lost", and its last part; made where
/// it is missing, or null.
[[nodiscard]] std::pair<nlohmann::ordered_json*, std::string> placeIn(
    nlohmann::ordered_json& object, std::string_view key);

}  // namespace macula::measure
