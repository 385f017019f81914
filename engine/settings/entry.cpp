#include "engine/settings/entry.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/nearest.h"

namespace macula::settings {
namespace {

/// Longer values are cut in messages, so that a damaged file cannot fill the screen.
constexpr std::size_t kShownCharacters = 80;

template <typename Integer>
Binding bindInteger(Integer& field) {
  Binding binding;
  binding.type = Type::Int;
  binding.get = [&field] { return Value{static_cast<std::int64_t>(field)}; };
  binding.set = [&field](const Value& value) {
    field = static_cast<Integer>(std::get<std::int64_t>(value));
  };
  // Bounds of 64 bits are the value's own and stay unsaid; a double could not name them anyway.
  if constexpr (sizeof(Integer) < sizeof(std::int64_t)) {
    binding.limits.min = static_cast<double>(std::numeric_limits<Integer>::min());
    binding.limits.max = static_cast<double>(std::numeric_limits<Integer>::max());
  } else if constexpr (std::is_unsigned_v<Integer>) {
    binding.limits.min = 0.0;
  }
  return binding;
}

template <typename Text>
Binding bindText(Text& field, Type type) {
  Binding binding;
  binding.type = type;
  if constexpr (std::is_same_v<Text, std::string>) {
    binding.get = [&field] { return Value{field}; };
  } else {
    binding.get = [&field] { return Value{field.string()}; };
  }
  binding.set = [&field](const Value& value) { field = std::get<std::string>(value); };
  return binding;
}

template <typename Triple>
Binding bindTriple(Triple& field) {
  Binding binding;
  binding.type = Type::Colour;
  binding.get = [&field] { return Value{glm::vec3{field[0], field[1], field[2]}}; };
  binding.set = [&field](const Value& value) {
    const auto& colour = std::get<glm::vec3>(value);
    field = Triple{colour.r, colour.g, colour.b};
  };
  return binding;
}

Range intersect(const Range& wanted, const Range& limits) {
  Range both = wanted;
  if (limits.min > both.min) {
    both.min = limits.min;
    both.minExclusive = false;
  }
  if (limits.max < both.max) {
    both.max = limits.max;
    both.maxExclusive = false;
  }
  return both;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

Binding bindField(bool& field) {
  Binding binding;
  binding.type = Type::Bool;
  binding.get = [&field] { return Value{field}; };
  binding.set = [&field](const Value& value) { field = std::get<bool>(value); };
  return binding;
}

Binding bindField(int& field) { return bindInteger(field); }
Binding bindField(std::uint32_t& field) { return bindInteger(field); }
Binding bindField(std::int64_t& field) { return bindInteger(field); }
Binding bindField(std::uint64_t& field) { return bindInteger(field); }

Binding bindField(float& field) {
  Binding binding;
  binding.type = Type::Real;
  binding.get = [&field] { return Value{shortestDouble(field)}; };
  binding.set = [&field](const Value& v) { field = static_cast<float>(std::get<double>(v)); };
  binding.singlePrecision = true;
  return binding;
}

Binding bindField(double& field) {
  Binding binding;
  binding.type = Type::Real;
  binding.get = [&field] { return Value{field}; };
  binding.set = [&field](const Value& value) { field = std::get<double>(value); };
  return binding;
}

Binding bindField(std::string& field) { return bindText(field, Type::Text); }
Binding bindField(std::filesystem::path& field) { return bindText(field, Type::Path); }
Binding bindField(glm::vec3& field) { return bindTriple(field); }
Binding bindField(std::array<float, 3>& field) { return bindTriple(field); }

Entry::Entry(Description description, Binding binding, Range range,
             std::vector<std::string> choices)
    : description_(std::move(description)),
      binding_(std::move(binding)),
      range_(intersect(range, binding_.limits)),
      choices_(std::move(choices)),
      default_(binding_.get()) {
  if (description_.group.empty()) {
    description_.group = description_.key.substr(0, description_.key.find('.'));
  }
  if (const auto result = checked(default_); std::holds_alternative<std::string>(result)) {
    throw std::logic_error("the default of setting '" + key() + "', '" + formatValue(default_) +
                           "', " + std::get<std::string>(result));
  }
}

std::string Entry::option() const { return "--" + (alias().empty() ? key() : alias()); }

std::string Entry::allowed() const {
  if (!choices_.empty()) return "one of " + joined(choices_);
  const std::string bounds = range_.text();
  const auto with = [&](const char* noun) { return bounds.empty() ? noun : noun + (" " + bounds); };
  switch (type()) {
    case Type::Bool:
      return "on or off (true/false, 1/0)";
    case Type::Int:
      return with("a whole number");
    case Type::Real:
      return with("a number");
    case Type::Colour:
      return with("R,G,B, each") + (bounds.empty() ? " a number" : "");
    case Type::Path:
      return "a path";
    case Type::Choice:
    case Type::Text:
      break;
  }
  return "text";
}

std::variant<Value, std::string> Entry::checked(const Value& value) const {
  const std::string outOfRange = "is out of range";
  switch (type()) {
    case Type::Bool:
      if (std::holds_alternative<bool>(value)) return value;
      return "is neither on nor off";
    case Type::Int: {
      const auto* number = std::get_if<std::int64_t>(&value);
      if (number == nullptr) return "is not a whole number";
      const bool listed = choices_.empty() || std::find(choices_.begin(), choices_.end(),
                                                        formatValue(value)) != choices_.end();
      if (!listed || !range_.holds(static_cast<double>(*number))) return outOfRange;
      return value;
    }
    case Type::Real: {
      double number = 0.0;
      if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        number = static_cast<double>(*whole);
      } else if (const auto* real = std::get_if<double>(&value)) {
        number = *real;
      } else {
        return "is not a number";
      }
      if (binding_.singlePrecision && std::isfinite(number)) {
        // Checked as the field will hold it: rounding to float may cross an exclusive bound.
        if (std::abs(number) > std::numeric_limits<float>::max()) return outOfRange;
        number = shortestDouble(static_cast<float>(number));
      }
      if (!range_.holds(number)) return outOfRange;
      return Value{number};
    }
    case Type::Colour: {
      const auto* colour = std::get_if<glm::vec3>(&value);
      if (colour == nullptr) return "is not a colour";
      for (int i = 0; i < 3; ++i) {
        const float component = (*colour)[i];
        if (!std::isfinite(component) || !range_.holds(shortestDouble(component))) {
          return outOfRange;
        }
      }
      return value;
    }
    case Type::Choice: {
      const auto* word = std::get_if<std::string>(&value);
      if (word == nullptr) return "is not text";
      if (std::find(choices_.begin(), choices_.end(), *word) != choices_.end()) return value;
      return "is not known (nearest: '" +
             nearestName(std::string_view(*word).substr(0, kShownCharacters), choices_) + "')";
    }
    case Type::Text:
    case Type::Path: {
      const auto* text = std::get_if<std::string>(&value);
      if (text == nullptr) return "is not text";
      // A path with a zero byte would be cut there by the operating system.
      if (text->find('\0') != std::string::npos) return "holds a zero byte";
      return value;
    }
  }
  return "has an unknown type";
}

void Entry::refuse(std::string_view where, std::string_view shown, std::string_view reason) const {
  const std::string cut = shown.size() > kShownCharacters ? "..." : "";
  const std::string unitText = unit().empty() ? "" : " (" + unit() + ")";
  failInput("{}: '{}{}' {}; {} takes {}{}", where, shown.substr(0, kShownCharacters), cut, reason,
            key(), allowed(), unitText);
}

void Entry::set(const Value& value, std::string_view where) {
  const auto result = checked(value);
  if (const auto* reason = std::get_if<std::string>(&result)) {
    refuse(where, formatValue(value), *reason);
  }
  binding_.set(std::get<Value>(result));
}

void Entry::setText(std::string_view text, std::string_view where) {
  std::optional<Value> value;
  switch (type()) {
    case Type::Bool:
      if (const auto flag = parseBool(text)) value = *flag;
      break;
    case Type::Int:
      if (const auto number = parseInt(text)) value = *number;
      break;
    case Type::Real:
      if (const auto number = parseReal(text)) value = *number;
      break;
    case Type::Colour:
      if (const auto colour = parseColour(text)) value = *colour;
      break;
    case Type::Choice:
    case Type::Text:
    case Type::Path:
      value = std::string(text);
      break;
  }
  if (!value) {
    const char* reason = type() == Type::Bool     ? "is neither on nor off"
                         : type() == Type::Int    ? "is not a whole number"
                         : type() == Type::Colour ? "is not a colour of three finite numbers"
                                                  : "is not a finite number";
    refuse(where, text, reason);
  }
  const auto result = checked(*value);
  if (const auto* reason = std::get_if<std::string>(&result)) refuse(where, text, *reason);
  binding_.set(std::get<Value>(result));
}

}  // namespace macula::settings
