#include "engine/measure/frame_record.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

namespace macula::measure {

using Json = nlohmann::ordered_json;

namespace {

bool fits(const Value& value, ValueType type) {
  switch (type) {
    case ValueType::Flag:
      return std::holds_alternative<bool>(value);
    case ValueType::Count:
      return std::holds_alternative<std::uint64_t>(value);
    case ValueType::Number:
      return std::holds_alternative<double>(value);
    case ValueType::Text:
      break;
  }
  return std::holds_alternative<std::string>(value);
}

/// "fragments" of "fragments.lost".
std::string_view levelOf(std::string_view key) {
  const std::size_t dot = key.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : key.substr(0, dot);
}

/// Levels of keys that hold at least one value.
std::set<std::string_view> filledLevels(const FrameRecord& record, unsigned places) {
  std::set<std::string_view> levels;
  for (std::size_t row = 0; row < kMetrics.size(); ++row) {
    if (!kMetrics[row].in(places) || record.at(row).index() == 0) continue;
    levels.insert(levelOf(kMetrics[row].name));
  }
  return levels;
}

}  // namespace

void FrameRecord::put(std::size_t row, Value value) {
  if (!fits(value, kMetrics[row].type)) {
    throw std::logic_error(std::string(kMetrics[row].name) + ": a value of another type");
  }
  // JSON has no NaN and no infinity: both mean that there is no such value.
  const auto* const number = std::get_if<double>(&value);
  values_[row] = number != nullptr && !std::isfinite(*number) ? Value() : std::move(value);
}

std::optional<double> FrameRecord::number(std::size_t row) const {
  if (const auto* const count = std::get_if<std::uint64_t>(&values_[row])) {
    return static_cast<double>(*count);
  }
  const auto* const number = std::get_if<double>(&values_[row]);
  return number == nullptr ? std::nullopt : std::optional(*number);
}

void setError(FrameRecord& record, const ImageError& error) {
  record.set("error.rmse", error.rmse);
  record.set("error.psnr_db", error.psnrDb);
  record.set("error.max", error.max);
  record.set("error.flip", error.flip);
  record.set("error.flip_gaze", error.flipGaze);
}

Json toJson(const Value& value) {
  return std::visit(
      [](const auto& held) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>) {
          return nullptr;
        } else {
          return held;
        }
      },
      value);
}

std::pair<Json*, std::string> placeIn(Json& object, std::string_view key) {
  Json* level = &object;
  for (std::size_t dot = key.find('.'); dot != std::string_view::npos; dot = key.find('.')) {
    level = &(*level)[std::string(key.substr(0, dot))];
    key.remove_prefix(dot + 1);
  }
  return {level, std::string(key)};
}

void addTo(Json& object, const FrameRecord& record, unsigned places, None none) {
  const std::set<std::string_view> filled = filledLevels(record, places);
  for (std::size_t row = 0; row < kMetrics.size(); ++row) {
    const Metric& metric = kMetrics[row];
    if (!metric.in(places)) continue;
    const bool inPoint = metric.in(places & kPoint);
    if (inPoint && metric.spread) continue;
    std::string_view key = inPoint ? metric.pointName() : metric.name;
    const std::string_view level = levelOf(key);
    const bool empty =
        level.empty() ? record.at(row).index() == 0 : !filled.contains(levelOf(metric.name));
    if (empty && none == None::Omit) continue;
    if (empty && none == None::Group && !level.empty()) key = level;
    const auto [parent, name] = placeIn(object, key);
    (*parent)[name] = empty ? Json(nullptr) : toJson(record.at(row));
  }
}

}  // namespace macula::measure
