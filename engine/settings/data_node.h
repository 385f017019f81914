// A value of a TOML or a JSON document, whichever it is.
#pragma once

#include "engine/settings/toml.h"

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace macula::settings {

/// A view of one value; the document must outlive it. Each getter gives nothing where the value is
/// of another type.
class DataNode {
 public:
  explicit DataNode(const toml::node& node) : toml_(&node) {}
  explicit DataNode(const nlohmann::json& value) : json_(&value) {}

  [[nodiscard]] bool isNull() const;  ///< of JSON; TOML has none
  [[nodiscard]] bool isTable() const;
  [[nodiscard]] std::optional<bool> flag() const;
  /// A number that is written as a whole one and fits into 64 bits with a sign.
  [[nodiscard]] std::optional<std::int64_t> whole() const;
  [[nodiscard]] std::optional<double> number() const;
  [[nodiscard]] std::optional<std::string> text() const;
  [[nodiscard]] std::optional<std::vector<DataNode>> list() const;

  /// Of a table: the value of a key, and all keys in the document's order or, of JSON, sorted.
  [[nodiscard]] std::optional<DataNode> find(const std::string& key) const;
  [[nodiscard]] std::vector<std::string> keys() const;
  /// The table as TOML has it; null where it is none.
  [[nodiscard]] const toml::table* toml() const;

  /// Where the value begins, from 1; 0 where the document does not tell, as JSON.
  [[nodiscard]] std::size_t line() const;
  /// The value in a message: quoted text, a number, "a list". One line, cut where it is long.
  [[nodiscard]] std::string shown() const;

 private:
  const toml::node* toml_ = nullptr;
  const nlohmann::json* json_ = nullptr;  ///< exactly one of the two is set
};

/// Text of a file for a message: one line, cut where it is long.
[[nodiscard]] std::string shownText(std::string_view text);

}  // namespace macula::settings
