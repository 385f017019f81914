#include "engine/recording/json_fields.h"

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/nearest.h"

namespace macula::recording {

using nlohmann::json;

namespace {

/// Longer texts of a damaged file are cut where they are shown.
constexpr std::size_t kShownCharacters = 60;

std::string shown(std::string_view text) {
  return oneLine(text.substr(0, kShownCharacters)) + (text.size() > kShownCharacters ? "..." : "");
}

/// A number of an object or of a list in it; nothing where it is none.
std::optional<double> numberOf(const json& value) {
  if (value.is_number()) return value.get<double>();
  if (!value.is_string()) return std::nullopt;
  const auto& text = value.get_ref<const std::string&>();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  return std::nullopt;
}

}  // namespace

std::string Place::text() const {
  return line == 0 ? file : fmt::format("{}: line {}", file, line);
}

json parseObject(std::string_view text, const Place& place) {
  try {
    json value = json::parse(text);
    if (value.is_object()) return value;
  } catch (const json::parse_error& error) {
    failInput("{}: byte {}: is no JSON; restore the file as it was recorded", place.text(),
              error.byte);
  } catch (const json::exception&) {
    failInput("{}: holds a number that is too large; restore the file as it was recorded",
              place.text());
  }
  failInput("{}: is no JSON object; restore the file as it was recorded", place.text());
}

Fields::Fields(const json& object, std::string name, const Place& place)
    : object_(&object), name_(std::move(name)), place_(&place) {
  if (!object.is_object()) failInput("{}: '{}' is no object", place.text(), shown(name_));
}

void Fields::fail(const std::string& key, const std::string& what) const {
  failInput("{}: '{}{}{}' {}", place_->text(), name_, name_.empty() ? "" : ".", shown(key), what);
}

const json& Fields::at(const std::string& key) {
  asked_.push_back(key);
  const auto found = object_->find(key);
  if (found == object_->end()) fail(key, "is missing; restore the file as it was recorded");
  return *found;
}

double Fields::number(const std::string& key) {
  const std::optional<double> number = numberOf(at(key));
  if (!number) fail(key, "is no number");
  return *number;
}

float Fields::toSingle(const std::string& key, double number) const {
  if (std::isfinite(number) && std::abs(number) > std::numeric_limits<float>::max()) {
    fail(key, "is too large");
  }
  return static_cast<float>(number);
}

float Fields::single(const std::string& key) {
  return toSingle(key, number(key));
}

double Fields::finite(const std::string& key) {
  const double value = number(key);
  if (!std::isfinite(value)) fail(key, "is not finite");
  return value;
}

float Fields::singleIn(const std::string& key, float least, float most) {
  const float value = toSingle(key, finite(key));
  if (value < least || value > most) fail(key, fmt::format("is not from {} to {}", least, most));
  return value;
}

std::uint64_t Fields::whole(const std::string& key, std::uint64_t most) {
  const json& value = at(key);
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most) {
    fail(key, fmt::format("is no whole number from 0 to {}", most));
  }
  return value.get<std::uint64_t>();
}

bool Fields::flag(const std::string& key) {
  const json& value = at(key);
  const bool scalar = value.is_boolean() || value.is_string() || value.is_number();
  const std::optional<bool> flag = scalar ? settings::toBool(setting(key)) : std::nullopt;
  if (!flag) fail(key, "is neither true nor false; write one of them");
  return *flag;
}

std::string Fields::text(const std::string& key) {
  const json& value = at(key);
  if (!value.is_string()) fail(key, "is no text");
  return value.get<std::string>();
}

std::string Fields::textOrNull(const std::string& key) {
  return at(key).is_null() ? std::string{} : text(key);
}

glm::vec3 Fields::vector(const std::string& key) {
  const json& value = at(key);
  if (!value.is_array() || value.size() != 3) fail(key, "is no list of three numbers");
  glm::vec3 v{0.0F};
  for (int i = 0; i < 3; ++i) {
    const std::optional<double> number = numberOf(value[static_cast<std::size_t>(i)]);
    if (!number || !std::isfinite(*number)) fail(key, "holds what is no finite number");
    v[i] = toSingle(key, *number);
  }
  return v;
}

Fields Fields::object(const std::string& key) {
  return {at(key), name_.empty() ? key : name_ + "." + key, *place_};
}

std::size_t Fields::choice(const std::string& key, const std::vector<std::string_view>& choices) {
  const std::string value = text(key);
  const auto found = std::find(choices.begin(), choices.end(), value);
  if (found == choices.end()) {
    const std::vector<std::string> names(choices.begin(), choices.end());
    fail(key, fmt::format("is '{}'; the nearest known is '{}'", shown(value),
                          nearestName(value.substr(0, kShownCharacters), names)));
  }
  return static_cast<std::size_t>(found - choices.begin());
}

settings::Value Fields::setting(const std::string& key) {
  const json& value = at(key);
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return value.get<double>();
  if (value.is_array()) return vector(key);
  if (!value.is_number()) fail(key, "is no value of a setting");
  // A whole number that is too large for one can only be meant as a real one.
  constexpr std::uint64_t kLargest = std::numeric_limits<std::int64_t>::max();
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > kLargest) {
    return value.get<double>();
  }
  return value.get<std::int64_t>();
}

std::vector<std::string> Fields::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object_->items()) keys.push_back(key);
  return keys;
}

void Fields::refuseOthers() const {
  for (const std::string& key : keys()) {
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    fail(key, fmt::format("is not known; the nearest is '{}'",
                          nearestName(key.substr(0, kShownCharacters), asked_)));
  }
}

}  // namespace macula::recording
