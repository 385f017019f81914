#include "engine/experiment/table_reader.h"

#include <algorithm>

#include "engine/core/error.h"
#include "engine/core/nearest.h"
#include "engine/settings/value.h"

namespace macula::experiment {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

}  // namespace

TableReader::TableReader(const toml::table& table, std::string_view file)
    : table_(table), file_(file) {}

std::string TableReader::place() const {
  return fmt::format("{}:{}", file_, std::max<toml::source_index>(1, table_.source().begin.line));
}

std::string TableReader::place(const char* key) const {
  const toml::node* node = table_.get(key);
  return node == nullptr ? place() : fmt::format("{}:{}", file_, node->source().begin.line);
}

const toml::node* TableReader::find(const char* key) {
  asked_.emplace_back(key);
  return table_.get(key);
}

void TableReader::failType(const char* key, std::string_view wanted) const {
  failInput("{}: {}: takes {}", place(key), key, wanted);
}

void TableReader::require(const char* key) const {
  if (!has(key)) failInput("{}: '{}' is missing here; add it", place(), key);
}

void TableReader::finish() const {
  for (const auto& [key, node] : table_) {
    const std::string name(key.str());
    if (std::find(asked_.begin(), asked_.end(), name) != asked_.end()) continue;
    failInput("{}:{}: unknown key '{}'; the nearest is '{}'", file_, key.source().begin.line,
              oneLine(name), nearestName(name, asked_));
  }
}

void TableReader::text(const char* key, std::string& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto text = node->value_exact<std::string>();
  if (!text || text->empty()) failType(key, "a text in quotes");
  value = *text;
}

void TableReader::choice(const char* key, std::size_t& value,
                         const std::vector<std::string>& names) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto text = node->value_exact<std::string>();
  const auto found = text ? std::find(names.begin(), names.end(), *text) : names.end();
  if (found == names.end()) {
    const std::string nearest =
        text ? fmt::format(" (nearest: '{}')", nearestName(oneLine(*text), names)) : "";
    failType(key, "one of " + joined(names) + nearest);
  }
  value = static_cast<std::size_t>(found - names.begin());
}

void TableReader::flag(const char* key, bool& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  std::optional<bool> flag = node->value_exact<bool>();
  if (const auto text = node->value_exact<std::string>()) flag = settings::toBool(*text);
  if (const auto number = node->value_exact<std::int64_t>()) flag = settings::toBool(*number);
  if (!flag) failType(key, settings::kBoolForm);
  value = *flag;
}

void TableReader::integer(const char* key, int& value, int least, int most) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto number = node->value_exact<std::int64_t>();
  if (!number || *number < least || *number > most) {
    failType(key, fmt::format("a whole number from {} to {}", least, most));
  }
  value = static_cast<int>(*number);
}

void TableReader::number(const char* key, double& value, double least, double most) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto number = node->is_number() ? node->value<double>() : std::nullopt;
  if (!number || !(*number >= least && *number <= most)) {
    std::string hint;
    if (most == 1.0) {  // a share, which may have been meant in percent
      const std::string text = number ? fmt::format("{}", *number) : node->value_or(std::string());
      hint = settings::shareHint(text, {.min = least, .max = most});
    }
    failType(key, fmt::format("a number from {:g} to {:g}{}", least, most, hint));
  }
  value = *number;
}

void TableReader::number(const char* key, std::optional<double>& value) {
  if (!has(key)) return;
  double found = 0.0;
  number(key, found, std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
  value = found;
}

std::vector<std::string> TableReader::textsOf(const char* key, const toml::node& node) const {
  std::vector<std::string> all;
  if (const toml::array* list = node.as_array()) {
    for (const toml::node& element : *list) {
      const auto text = element.value_exact<std::string>();
      if (!text || text->empty()) failType(key, "a list of texts in quotes");
      all.push_back(*text);
    }
  }
  if (all.empty()) failType(key, "a list of at least one text in quotes");
  return all;
}

void TableReader::texts(const char* key, std::vector<std::string>& value) {
  if (const toml::node* node = find(key)) value = textsOf(key, *node);
}

void TableReader::textOrTexts(const char* key, std::vector<std::string>& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto one = node->value_exact<std::string>();
  value = one && !one->empty() ? std::vector<std::string>{*one} : textsOf(key, *node);
}

void TableReader::textLists(const char* key, std::vector<std::vector<std::string>>& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const toml::array* list = node->as_array();
  if (list == nullptr || list->empty()) failType(key, "a list of lists of texts");
  value.clear();
  for (const toml::node& element : *list) value.push_back(textsOf(key, element));
}

void TableReader::integers(const char* key, std::vector<std::int64_t>& value, std::int64_t least,
                           std::int64_t most) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const toml::array* list = node->as_array();
  const std::string wanted =
      fmt::format("a list of at least one whole number from {} to {}", least, most);
  if (list == nullptr || list->empty()) failType(key, wanted);
  value.clear();
  for (const toml::node& element : *list) {
    const auto number = element.value_exact<std::int64_t>();
    if (!number || *number < least || *number > most) failType(key, wanted);
    value.push_back(*number);
  }
}

const toml::table* TableReader::table(const char* key) {
  const toml::node* node = find(key);
  if (node == nullptr) return nullptr;
  if (!node->is_table()) failType(key, "a table of settings, { name = value, ... }");
  return node->as_table();
}

std::vector<const toml::table*> TableReader::tables(const char* key) {
  std::vector<const toml::table*> all;
  const toml::node* node = find(key);
  if (node == nullptr) return all;
  const toml::array* list = node->as_array();
  if (list == nullptr) failType(key, "a list of tables");
  for (const toml::node& element : *list) {
    if (!element.is_table()) failType(key, "a list of tables");
    all.push_back(element.as_table());
  }
  return all;
}

}  // namespace macula::experiment
