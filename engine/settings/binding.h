// How a setting reaches the field that it sets, whatever the field's type.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <string>

#include "engine/settings/value.h"

namespace macula::settings {

/// Ties a setting to the field it sets. Made by the bindField() functions.
struct Binding {
  Type type = Type::Text;
  std::function<Value()> get;
  std::function<void(const Value&)> set;  ///< takes the alternative that belongs to `type`
  Range limits = {};                      ///< what the field's own type can hold
  bool singlePrecision = false;           ///< a Real whose field is a float
};

[[nodiscard]] Binding bindField(bool& field);
[[nodiscard]] Binding bindField(int& field);
[[nodiscard]] Binding bindField(std::uint32_t& field);
[[nodiscard]] Binding bindField(std::int64_t& field);
[[nodiscard]] Binding bindField(std::uint64_t& field);
[[nodiscard]] Binding bindField(float& field);
[[nodiscard]] Binding bindField(double& field);
[[nodiscard]] Binding bindField(std::string& field);
[[nodiscard]] Binding bindField(std::filesystem::path& field);
[[nodiscard]] Binding bindField(glm::vec3& field);
[[nodiscard]] Binding bindField(std::array<float, 3>& field);

}  // namespace macula::settings
