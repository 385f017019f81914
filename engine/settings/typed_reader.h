// The one way to read a table of TOML or an object of JSON: key by key, each with its type, range
// and unit. What is wrong, missing or unknown is an InputError that names its place and the key.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/settings/data_node.h"
#include "engine/settings/value.h"

namespace macula::settings {

/// Reads `get` (required), `find` (optional) and `take` (optional, leaves the variable alone). They
/// know bool (true, "on" or 1, as on a command line), int, std::int64_t, float and double (finite,
/// and within the range), std::string (not empty), glm::vec3, lists of texts, of lists of texts, of
/// whole numbers and of numbers (not empty), and Value. After the last key, finish() refuses what
/// nothing asked for. A unit, or what else helps to write the value, ends the message of a refusal
/// in parentheses.
class TypedReader {
 public:
  /// @param table must outlive the reader
  /// @param place begins messages: a file, to which TOML adds the line, or a file and a line
  /// @param advice what to do about a key that is missing
  TypedReader(DataNode table, std::string place, std::string advice = "add it");

  template <typename T>
  [[nodiscard]] T get(const std::string& key, const Range& range = {}, std::string_view unit = {}) {
    T value{};
    read({key, require(key), range, unit}, value);
    return value;
  }
  template <typename T>
  [[nodiscard]] std::optional<T> find(const std::string& key, const Range& range = {},
                                      std::string_view unit = {}) {
    return has(key) ? std::optional(get<T>(key, range, unit)) : std::nullopt;
  }
  template <typename T>
  void take(const std::string& key, T& value, const Range& range = {}, std::string_view unit = {}) {
    if (has(key)) value = get<T>(key, range, unit);
  }
  template <typename T>
  void take(const std::string& key, std::optional<T>& value, const Range& range = {},
            std::string_view unit = {}) {
    if (has(key)) value = get<T>(key, range, unit);
  }

  /// A number that may be infinite or NaN; JSON writes those as "inf", "-inf" and "nan".
  [[nodiscard]] double anyNumber(const std::string& key);
  [[nodiscard]] float anyFloat(const std::string& key);
  /// A text that may be empty; null counts as empty.
  [[nodiscard]] std::string textOrNull(const std::string& key);
  /// A list of texts, or one text without brackets.
  [[nodiscard]] std::vector<std::string> getTexts(const std::string& key);
  /// The index of a text among `names`.
  [[nodiscard]] std::size_t getChoice(const std::string& key,
                                      const std::vector<std::string>& names);
  /// For an enumeration whose enumerators are 0, 1, ... in the order of `names`.
  template <typename Enum>
  void takeChoice(const std::string& key, Enum& value, const std::vector<std::string>& names) {
    if (has(key)) value = static_cast<Enum>(getChoice(key, names));
  }

  /// A table within this one, whose keys are named with it in messages: "gaze.x".
  [[nodiscard]] TypedReader getTable(const std::string& key);
  /// The same; where it is missing, a reader of a table without keys.
  [[nodiscard]] TypedReader table(const std::string& key);
  /// A list of tables, `[[key]]` or `key = [{...}]`; empty where it is missing.
  [[nodiscard]] std::vector<TypedReader> tables(const std::string& key);

  /// Whether the key is there; from now on it is known.
  [[nodiscard]] bool has(const std::string& key);
  [[nodiscard]] bool holdsTable(const std::string& key);  ///< the same, of a table
  [[nodiscard]] std::vector<std::string> keys() const;
  /// The table as TOML has it; null where it is none or missing.
  [[nodiscard]] const toml::table* toml() const;
  /// @throws InputError for a key that nothing asked for, naming the nearest one that is known
  void finish() const;

  /// Where the table stands, and one of its keys: "file:line", or as the constructor was told.
  [[nodiscard]] std::string place() const;
  [[nodiscard]] std::string place(const std::string& key) const;
  /// Throws an InputError "place: 'key' what".
  [[noreturn]] void fail(const std::string& key, std::string_view what) const;

 private:
  struct At {
    const std::string& key;
    DataNode node;
    Range range;
    std::string_view unit;
  };
  TypedReader(std::optional<DataNode> table, const TypedReader& parent, std::string name);

  [[nodiscard]] DataNode require(const std::string& key);
  [[nodiscard]] float toFloat(const std::string& key, double number) const;
  [[nodiscard]] std::vector<DataNode> elements(const At& at, std::string_view wanted) const;
  [[nodiscard]] std::string nameOf(const std::string& key) const;
  [[nodiscard]] std::string placeAt(std::size_t line) const;
  [[noreturn]] void failValue(const At& at, std::string_view wanted) const;

  void read(const At& at, bool& value) const;
  void read(const At& at, int& value) const;
  void read(const At& at, std::int64_t& value) const;
  void read(const At& at, float& value) const;
  void read(const At& at, double& value) const;
  void read(const At& at, std::string& value) const;
  void read(const At& at, glm::vec3& value) const;
  void read(const At& at, std::vector<std::string>& value) const;
  void read(const At& at, std::vector<std::vector<std::string>>& value) const;
  void read(const At& at, std::vector<std::int64_t>& value) const;
  void read(const At& at, std::vector<double>& value) const;
  void read(const At& at, Value& value) const;

  std::optional<DataNode> table_;  ///< none: it is missing
  std::string place_;
  std::string advice_;
  std::string name_;  ///< of the table in messages; empty for the outermost
  std::vector<std::string> asked_;
};

/// @param advice what to do about a text that is damaged
/// @throws InputError naming place and byte where the text is not one JSON object
[[nodiscard]] nlohmann::json parseJsonObject(std::string_view text, const std::string& place,
                                             std::string_view advice);

}  // namespace macula::settings
