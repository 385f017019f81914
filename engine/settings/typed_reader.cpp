#include "engine/settings/typed_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/nearest.h"

namespace macula::settings {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

std::string withRange(std::string_view noun, const Range& range) {
  const std::string bounds = range.text();
  return fmt::format("{}{}{}", noun, bounds.empty() ? "" : " ", bounds);
}

}  // namespace

TypedReader::TypedReader(DataNode table, std::string place, std::string advice)
    : table_(table), place_(std::move(place)), advice_(std::move(advice)) {}

TypedReader::TypedReader(std::optional<DataNode> table, const TypedReader& parent, std::string name)
    : table_(table), place_(parent.place_), advice_(parent.advice_), name_(std::move(name)) {}

std::string TypedReader::nameOf(const std::string& key) const {
  return name_.empty() ? shownText(key) : name_ + "." + shownText(key);
}

std::string TypedReader::placeAt(std::size_t line) const {
  return line == 0 ? place_ : fmt::format("{}:{}", place_, line);
}

std::string TypedReader::place() const {
  return placeAt(table_ ? table_->line() : 0);
}

std::string TypedReader::place(const std::string& key) const {
  const auto node = table_ ? table_->find(key) : std::nullopt;
  return node ? placeAt(node->line()) : place();
}

void TypedReader::fail(const std::string& key, std::string_view what) const {
  failInput("{}: '{}' {}", place(key), nameOf(key), what);
}

void TypedReader::failValue(const At& at, std::string_view wanted) const {
  fail(at.key, fmt::format("is {}; give {}{}", at.node.shown(), wanted,
                           at.unit.empty() ? "" : fmt::format(" ({})", at.unit)));
}

bool TypedReader::has(const std::string& key) {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(key);
  return table_ && table_->find(key);
}

bool TypedReader::holdsTable(const std::string& key) {
  return has(key) && table_->find(key)->isTable();
}

DataNode TypedReader::require(const std::string& key) {
  if (!has(key)) fail(key, "is missing; " + advice_);
  return *table_->find(key);
}

std::vector<std::string> TypedReader::keys() const {
  return table_ ? table_->keys() : std::vector<std::string>{};
}

const toml::table* TypedReader::toml() const {
  return table_ ? table_->toml() : nullptr;
}

void TypedReader::finish() const {
  for (const std::string& key : keys()) {
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    fail(key, asked_.empty() ? std::string("is not known; this table has no keys")
                             : fmt::format("is not known; the nearest is '{}'",
                                           nearestName(shownText(key), asked_)));
  }
}

TypedReader TypedReader::table(const std::string& key) {
  if (!has(key)) return {std::nullopt, *this, nameOf(key)};
  return getTable(key);
}

TypedReader TypedReader::getTable(const std::string& key) {
  const DataNode node = require(key);
  if (!node.isTable()) failValue({key, node, {}, {}}, "a table");
  return {node, *this, nameOf(key)};
}

std::vector<TypedReader> TypedReader::tables(const std::string& key) {
  std::vector<TypedReader> all;
  if (!has(key)) return all;
  const At at{key, require(key), {}, {}};
  const auto list = at.node.list();
  const bool good =
      list && std::all_of(list->begin(), list->end(), [](const auto& e) { return e.isTable(); });
  if (!good) failValue(at, "a list of tables");
  for (const DataNode& element : *list) all.push_back({element, *this, ""});
  return all;
}

double TypedReader::anyNumber(const std::string& key) {
  const DataNode node = require(key);
  if (const auto number = node.number()) return *number;
  const std::string text = node.text().value_or("");
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  failValue({key, node, {}, {}}, "a number");
}

float TypedReader::anyFloat(const std::string& key) {
  return toFloat(key, anyNumber(key));
}

/// Rounds to the nearest float, where there is one.
float TypedReader::toFloat(const std::string& key, double number) const {
  if (std::isfinite(number) && std::abs(number) > std::numeric_limits<float>::max()) {
    fail(key, "is too large for a number of 32 bits");
  }
  return static_cast<float>(number);
}

std::string TypedReader::textOrNull(const std::string& key) {
  const DataNode node = require(key);
  const auto text = node.text();
  if (!text && !node.isNull()) failValue({key, node, {}, {}}, "a text");
  return text.value_or("");
}

std::vector<std::string> TypedReader::getTexts(const std::string& key) {
  const auto one = require(key).text();
  if (one && !one->empty()) return {*one};
  return get<std::vector<std::string>>(key);
}

std::size_t TypedReader::getChoice(const std::string& key, const std::vector<std::string>& names) {
  const At at{key, require(key), {}, {}};
  const auto text = at.node.text();
  const auto found = text ? std::find(names.begin(), names.end(), *text) : names.end();
  if (found == names.end()) {
    failValue(
        at, fmt::format(
                "one of {}{}", joined(names),
                text ? fmt::format(" (nearest: '{}')", nearestName(shownText(*text), names)) : ""));
  }
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<DataNode> TypedReader::elements(const At& at, std::string_view wanted) const {
  const auto list = at.node.list();
  if (!list || list->empty()) failValue(at, wanted);
  return *list;
}

void TypedReader::read(const At& at, bool& value) const {
  std::optional<bool> flag = at.node.flag();
  if (const auto text = at.node.text()) flag = toBool(*text);
  if (const auto number = at.node.whole()) flag = toBool(*number);
  if (!flag) failValue(at, kBoolForm);
  value = *flag;
}

void TypedReader::read(const At& at, std::int64_t& value) const {
  const auto number = at.node.whole();
  if (!number || !at.range.holds(static_cast<double>(*number))) {
    failValue(at, withRange("a whole number", at.range));
  }
  value = *number;
}

void TypedReader::read(const At& at, int& value) const {
  std::int64_t wide = 0;
  Range range = at.range;
  range.min = std::max<double>(range.min, std::numeric_limits<int>::min());
  range.max = std::min<double>(range.max, std::numeric_limits<int>::max());
  read({at.key, at.node, range, at.unit}, wide);
  value = static_cast<int>(wide);
}

void TypedReader::read(const At& at, double& value) const {
  const auto number = at.node.number();
  if (!number || !at.range.holds(*number)) {
    // A share may have been meant in percent.
    const std::string text = number ? fmt::format("{}", *number) : at.node.text().value_or("");
    failValue(at, withRange("a finite number", at.range) +
                      (at.range.max == 1.0 ? shareHint(text, at.range) : std::string()));
  }
  value = *number;
}

void TypedReader::read(const At& at, float& value) const {
  double wide = 0.0;
  read(at, wide);
  value = toFloat(at.key, wide);
}

void TypedReader::read(const At& at, std::string& value) const {
  const auto text = at.node.text();
  if (!text || text->empty()) failValue(at, "a text in quotes");
  value = *text;
}

void TypedReader::read(const At& at, glm::vec3& value) const {
  const std::string_view wanted = "a list of three numbers";
  const std::vector<DataNode> list = elements(at, wanted);
  if (list.size() != 3) failValue(at, wanted);
  for (int i = 0; i < 3; ++i) {
    float component = 0.0F;
    read(At{at.key, list[static_cast<std::size_t>(i)], at.range, at.unit}, component);
    value[i] = component;
  }
}

void TypedReader::read(const At& at, std::vector<std::string>& value) const {
  for (const DataNode& element : elements(at, "a list of at least one text in quotes")) {
    read(At{at.key, element, at.range, at.unit}, value.emplace_back());
  }
}

void TypedReader::read(const At& at, std::vector<std::vector<std::string>>& value) const {
  for (const DataNode& element : elements(at, "a list of lists of texts")) {
    read(At{at.key, element, at.range, at.unit}, value.emplace_back());
  }
}

void TypedReader::read(const At& at, std::vector<std::int64_t>& value) const {
  const std::string wanted = withRange("a list of at least one whole number", at.range);
  for (const DataNode& element : elements(at, wanted)) {
    read(At{at.key, element, at.range, at.unit}, value.emplace_back());
  }
}

void TypedReader::read(const At& at, std::vector<double>& value) const {
  const std::string wanted = withRange("a list of at least one number", at.range);
  for (const DataNode& element : elements(at, wanted)) {
    read(At{at.key, element, at.range, at.unit}, value.emplace_back());
  }
}

void TypedReader::read(const At& at, Value& value) const {
  if (const auto flag = at.node.flag()) {
    value = *flag;
  } else if (const auto text = at.node.text()) {
    value = *text;
  } else if (const auto whole = at.node.whole()) {
    value = *whole;
  } else if (const auto number = at.node.number()) {
    value = *number;
  } else if (at.node.list()) {
    glm::vec3 colour{0.0F};
    read(at, colour);
    value = colour;
  } else {
    failValue(at, "a value of a setting");
  }
}

nlohmann::json parseJsonObject(std::string_view text, const std::string& place,
                               std::string_view advice) {
  try {
    nlohmann::json value = nlohmann::json::parse(text);
    if (value.is_object()) return value;
  } catch (const nlohmann::json::parse_error& error) {
    failInput("{}: byte {}: is no JSON; {}", place, error.byte, advice);
  } catch (const nlohmann::json::exception&) {
    failInput("{}: holds a number that is too large; {}", place, advice);
  }
  failInput("{}: is no JSON object; {}", place, advice);
}

}  // namespace macula::settings
