// A TOML table that is read key by key: a wrong type or a key that nobody asked for is an error
// with its place.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/settings/toml.h"

namespace macula::experiment {

/// Every getter leaves `value` alone where the key is missing, and throws an InputError
/// "file:line: key: ..." where the value is not of its kind. finish() refuses what is left over.
class TableReader {
 public:
  /// @param table must outlive the reader · @param file for messages
  TableReader(const toml::table& table, std::string_view file);

  void text(const char* key, std::string& value);
  /// One of `names`; gives its index.
  void choice(const char* key, std::size_t& value, const std::vector<std::string>& names);
  void flag(const char* key, bool& value);
  void integer(const char* key, int& value, int least, int most);
  /// @param least, most inclusive
  void number(const char* key, double& value, double least, double most);
  /// Any finite one.
  void number(const char* key, std::optional<double>& value);
  /// Neither the list nor its members may be empty.
  void texts(const char* key, std::vector<std::string>& value);
  /// The same, or one text without brackets.
  void textOrTexts(const char* key, std::vector<std::string>& value);
  void integers(const char* key, std::vector<std::int64_t>& value, std::int64_t least,
                std::int64_t most);
  void textLists(const char* key, std::vector<std::vector<std::string>>& value);
  /// Null where the key is missing.
  [[nodiscard]] const toml::table* table(const char* key);
  /// An array of tables, `[[key]]` or `key = [{...}]`, each to be read by a reader of its own.
  [[nodiscard]] std::vector<const toml::table*> tables(const char* key);

  [[nodiscard]] bool has(const char* key) const { return table_.contains(key); }
  /// @throws InputError naming the key where it is missing
  void require(const char* key) const;
  /// @throws InputError for a key that no getter asked for, naming the nearest one
  void finish() const;
  /// "file:line" of the table, or of a key of it.
  [[nodiscard]] std::string place() const;
  [[nodiscard]] std::string place(const char* key) const;

 private:
  const toml::node* find(const char* key);
  [[noreturn]] void failType(const char* key, std::string_view wanted) const;
  std::vector<std::string> textsOf(const char* key, const toml::node& node) const;

  const toml::table& table_;
  std::string_view file_;
  std::vector<std::string> asked_;
};

}  // namespace macula::experiment
