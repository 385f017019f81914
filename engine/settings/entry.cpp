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

constexpr const char* kOutOfRange = "is out of range";

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

Entry::Entry(Description description, Binding binding, Range range,
             std::vector<std::string> choices)
    : description_(std::move(description)),
      binding_(std::move(binding)),
      range_(intersect(range, binding_.limits)),
      choices_(std::move(choices)),
      default_(binding_.get()) {
  if (const Checked checked = check(default_); !checked.refusal.empty()) {
    throw std::logic_error("the default of setting '" + key() + "', '" + formatValue(default_) +
                           "', " + checked.refusal);
  }
}

std::string Entry::option() const {
  return "--" + (alias().empty() ? key() : alias());
}

std::string Entry::allowed() const {
  if (!choices_.empty()) return "one of " + joined(choices_);
  const std::string bounds = range_.text();
  const auto with = [&](const char* noun) { return bounds.empty() ? noun : noun + (" " + bounds); };
  switch (type()) {
    case Type::Bool:
      return std::string(kBoolForm);
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

Entry::Checked Entry::checkInt(const Value& value) const {
  const auto* number = std::get_if<std::int64_t>(&value);
  if (number == nullptr) return {.refusal = "is not a whole number"};
  const bool listed = choices_.empty() || std::find(choices_.begin(), choices_.end(),
                                                    formatValue(value)) != choices_.end();
  if (!listed || !range_.holds(static_cast<double>(*number))) return {.refusal = kOutOfRange};
  return {.value = value};
}

Entry::Checked Entry::checkReal(const Value& value) const {
  double number = 0.0;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    number = static_cast<double>(*whole);
  } else if (const auto* real = std::get_if<double>(&value)) {
    number = *real;
  } else {
    return {.refusal = "is not a number"};
  }
  if (binding_.singlePrecision && std::isfinite(number)) {
    // Checked as the field will hold it: rounding to float may cross an exclusive bound.
    if (std::abs(number) > std::numeric_limits<float>::max()) return {.refusal = kOutOfRange};
    number = shortestDouble(static_cast<float>(number));
  }
  if (!range_.holds(number)) return {.refusal = kOutOfRange};
  return {.value = number};
}

Entry::Checked Entry::checkColour(const Value& value) const {
  const auto* colour = std::get_if<glm::vec3>(&value);
  if (colour == nullptr) return {.refusal = "is not a colour"};
  for (int i = 0; i < 3; ++i) {
    const float component = (*colour)[i];
    if (!std::isfinite(component) || !range_.holds(shortestDouble(component))) {
      return {.refusal = kOutOfRange};
    }
  }
  return {.value = value};
}

Entry::Checked Entry::checkText(const Value& value) const {
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) return {.refusal = "is not text"};
  if (type() == Type::Choice) {
    if (std::find(choices_.begin(), choices_.end(), *text) != choices_.end())
      return {.value = value};
    const std::string_view shown = std::string_view(*text).substr(0, kShownCharacters);
    return {.refusal = "is not known (nearest: '" + nearestName(shown, choices_) + "')"};
  }
  // The operating system would cut a path there.
  if (text->find('\0') != std::string::npos) return {.refusal = "holds a zero byte"};
  return {.value = value};
}

Entry::Checked Entry::check(const Value& value) const {
  switch (type()) {
    case Type::Bool:
      if (const auto flag = toBool(value)) return {.value = *flag};
      return {.refusal = "is neither on nor off"};
    case Type::Int:
      return checkInt(value);
    case Type::Real:
      return checkReal(value);
    case Type::Colour:
      return checkColour(value);
    case Type::Choice:
    case Type::Text:
    case Type::Path:
      break;
  }
  return checkText(value);
}

Entry::Checked Entry::parse(std::string_view text) const {
  switch (type()) {
    case Type::Int:
      if (const auto number = parseInt(text)) return check(*number);
      return {.refusal = "is not a whole number"};
    case Type::Real:
      if (const auto number = parseReal(text)) return check(*number);
      return {.refusal = "is not a finite number"};
    case Type::Colour:
      if (const auto colour = parseColour(text)) return check(*colour);
      return {.refusal = "is not three finite numbers"};
    case Type::Bool:
    case Type::Choice:
    case Type::Text:
    case Type::Path:
      break;
  }
  return check(std::string(text));
}

void Entry::reset() {
  binding_.set(default_);
  setAt_.clear();
}

void Entry::assign(const Checked& checked, std::string_view shown, std::string_view where) {
  if (!checked.refusal.empty()) {
    failInput("{}: '{}{}' {}; {} takes {}{}{}", where, shown.substr(0, kShownCharacters),
              shown.size() > kShownCharacters ? "..." : "", checked.refusal, key(), allowed(),
              unit().empty() ? "" : " (" + unit() + ")",
              description_.share ? shareHint(shown, range_) : "");
  }
  binding_.set(checked.value);
  setAt_ = where;
}

void Entry::set(const Value& value, std::string_view where) {
  assign(check(value), formatValue(value), where);
}

void Entry::setText(std::string_view text, std::string_view where) {
  assign(parse(text), text, where);
}

}  // namespace macula::settings
