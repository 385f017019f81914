#include "engine/settings/data_node.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"

namespace macula::settings {

std::string shownText(std::string_view text) {
  constexpr std::size_t kShownCharacters = 60;
  return oneLine(text.substr(0, kShownCharacters)) + (text.size() > kShownCharacters ? "..." : "");
}

bool DataNode::isNull() const {
  return json_ != nullptr && json_->is_null();
}

bool DataNode::isTable() const {
  return json_ != nullptr ? json_->is_object() : toml_->is_table();
}

std::optional<bool> DataNode::flag() const {
  if (json_ == nullptr) return toml_->value_exact<bool>();
  return json_->is_boolean() ? std::optional(json_->get<bool>()) : std::nullopt;
}

std::optional<std::int64_t> DataNode::whole() const {
  if (json_ == nullptr) return toml_->value_exact<std::int64_t>();
  constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  const bool fits = json_->is_number_unsigned() ? json_->get<std::uint64_t>() <= kMost
                                                : json_->is_number_integer();
  return fits ? std::optional(json_->get<std::int64_t>()) : std::nullopt;
}

std::optional<double> DataNode::number() const {
  if (json_ == nullptr) return toml_->is_number() ? toml_->value<double>() : std::nullopt;
  return json_->is_number() ? std::optional(json_->get<double>()) : std::nullopt;
}

std::optional<std::string> DataNode::text() const {
  if (json_ == nullptr) return toml_->value_exact<std::string>();
  return json_->is_string() ? std::optional(json_->get<std::string>()) : std::nullopt;
}

std::optional<std::vector<DataNode>> DataNode::list() const {
  std::vector<DataNode> elements;
  if (json_ != nullptr) {
    if (!json_->is_array()) return std::nullopt;
    for (const nlohmann::json& element : *json_) elements.emplace_back(element);
  } else {
    const toml::array* array = toml_->as_array();
    if (array == nullptr) return std::nullopt;
    for (const toml::node& element : *array) elements.emplace_back(element);
  }
  return elements;
}

std::optional<DataNode> DataNode::find(const std::string& key) const {
  if (!isTable()) return std::nullopt;
  if (json_ != nullptr) {
    const auto found = json_->find(key);
    return found == json_->end() ? std::nullopt : std::optional(DataNode(*found));
  }
  const toml::node* node = toml_->as_table()->get(key);
  return node == nullptr ? std::nullopt : std::optional(DataNode(*node));
}

std::vector<std::string> DataNode::keys() const {
  std::vector<std::string> keys;
  if (!isTable()) return keys;
  if (json_ != nullptr) {
    for (const auto& [key, value] : json_->items()) keys.push_back(key);
  } else {
    for (const auto& [key, node] : *toml_->as_table()) keys.emplace_back(key.str());
  }
  return keys;
}

const toml::table* DataNode::toml() const {
  return toml_ == nullptr ? nullptr : toml_->as_table();
}

std::size_t DataNode::line() const {
  if (toml_ == nullptr) return 0;
  return std::max<std::size_t>(1, toml_->source().begin.line);
}

std::string DataNode::shown() const {
  if (const auto value = text()) return "'" + shownText(*value) + "'";
  if (const auto value = flag()) return *value ? "true" : "false";
  if (const auto value = whole()) return std::to_string(*value);
  if (const auto value = number()) return fmt::format("{}", *value);
  if (isNull()) return "null";
  if (isTable()) return "a table";
  return list() ? "a list" : "a date or time";
}

}  // namespace macula::settings
