// The fields of a JSON object, each asked for by name and type; what is wrong is named with its
// place.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/settings/value.h"

namespace macula::recording {

/// Where a text stands, for messages.
struct Place {
  std::string file;
  std::size_t line = 0;  ///< from 1; 0 where the text is the whole file
  [[nodiscard]] std::string text() const;
};

/// @throws InputError naming place and column where the text is not one JSON object
[[nodiscard]] nlohmann::json parseObject(std::string_view text, const Place& place);

class Fields {
 public:
  /// @param name of the object in messages; empty for the outermost
  /// @throws InputError where `object` is none
  Fields(const nlohmann::json& object, std::string name, const Place& place);

  /// A number, or the text "nan", "inf" or "-inf". @throws InputError as all of these
  [[nodiscard]] double number(const std::string& key);
  [[nodiscard]] float single(const std::string& key);
  [[nodiscard]] double finite(const std::string& key);
  /// A finite float from `least` to `most`.
  [[nodiscard]] float singleIn(const std::string& key, float least, float most);
  [[nodiscard]] std::uint64_t whole(const std::string& key,
                                    std::uint64_t most = std::numeric_limits<std::uint64_t>::max());
  [[nodiscard]] bool flag(const std::string& key);
  [[nodiscard]] std::string text(const std::string& key);
  /// Empty for null.
  [[nodiscard]] std::string textOrNull(const std::string& key);
  /// Three finite numbers.
  [[nodiscard]] glm::vec3 vector(const std::string& key);
  [[nodiscard]] Fields object(const std::string& key);
  /// The index of a text among `choices`.
  [[nodiscard]] std::size_t choice(const std::string& key,
                                   const std::vector<std::string_view>& choices);
  /// A setting's value: true, a number, text, or three numbers.
  [[nodiscard]] settings::Value setting(const std::string& key);

  [[nodiscard]] bool has(const std::string& key) const { return object_->contains(key); }
  [[nodiscard]] std::vector<std::string> keys() const;
  /// To be called last. @throws InputError naming a key that nobody asked for and the nearest known
  void refuseOthers() const;

  /// Throws an InputError about a key.
  [[noreturn]] void fail(const std::string& key, const std::string& what) const;

 private:
  [[nodiscard]] const nlohmann::json& at(const std::string& key);
  [[nodiscard]] float toSingle(const std::string& key, double number) const;

  const nlohmann::json* object_;
  std::string name_;
  const Place* place_;
  std::vector<std::string> asked_;
};

}  // namespace macula::recording
