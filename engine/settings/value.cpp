#include "engine/settings/value.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace macula::settings {
namespace {

/// Without blanks around it and without one leading plus, which std::from_chars does not know.
std::string_view trimNumber(std::string_view text) {
  constexpr std::string_view kBlanks = " \t";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  text = text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  return text;
}

template <typename Number>
std::optional<Number> parseWhole(std::string_view text) {
  text = trimNumber(text);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

bool Range::holds(double number) const {
  if (!std::isfinite(number)) return false;
  const bool above = minExclusive ? number > min : number >= min;
  const bool below = maxExclusive ? number < max : number <= max;
  return above && below;
}

std::string Range::text() const {
  const bool hasMin = std::isfinite(min);
  const bool hasMax = std::isfinite(max);
  if (hasMin && hasMax && !minExclusive && !maxExclusive) {
    return fmt::format("from {} to {}", min, max);
  }
  std::string bounds;
  if (hasMin) bounds = fmt::format("{} {}", minExclusive ? ">" : ">=", min);
  if (hasMin && hasMax) bounds += " and ";
  if (hasMax) bounds += fmt::format("{} {}", maxExclusive ? "<" : "<=", max);
  return bounds;
}

std::optional<bool> parseBool(std::string_view text) {
  if (text == "true" || text == "on" || text == "1") return true;
  if (text == "false" || text == "off" || text == "0") return false;
  return std::nullopt;
}

std::optional<bool> toBool(const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag;
  if (const auto* text = std::get_if<std::string>(&value)) return parseBool(*text);
  const auto* number = std::get_if<std::int64_t>(&value);
  if (number == nullptr || *number < 0 || *number > 1) return std::nullopt;
  return *number == 1;
}

std::optional<std::int64_t> parseInt(std::string_view text) {
  return parseWhole<std::int64_t>(text);
}

std::optional<double> parseReal(std::string_view text) {
  const auto number = parseWhole<double>(text);
  if (!number || !std::isfinite(*number)) return std::nullopt;
  return number;
}

std::optional<glm::vec3> parseColour(std::string_view text) {
  glm::vec3 colour{0.0F};
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i == 2)) return std::nullopt;
    const auto number = parseReal(text.substr(0, comma));
    if (!number || std::abs(*number) > std::numeric_limits<float>::max()) return std::nullopt;
    colour[i] = static_cast<float>(*number);
    if (i < 2) text.remove_prefix(comma + 1);
  }
  return colour;
}

std::string shareHint(std::string_view text, const Range& range) {
  constexpr double kPercent = 100.0;
  constexpr double kLeastPlain = 2.0;  // what is less, without a sign, is rather too large a share
  const std::size_t last = text.find_last_not_of(" \t");
  const bool hasSign = last != std::string_view::npos && text[last] == '%';
  const std::optional<double> percent = parseReal(hasSign ? text.substr(0, last) : text);
  if (!percent || !range.holds(*percent / kPercent)) return {};
  if (!hasSign && std::abs(*percent) < kLeastPlain) return {};
  return fmt::format("; write {:g} for {:g} %", *percent / kPercent, *percent);
}

std::string formatValue(const Value& value) {
  struct Format {
    std::string operator()(bool flag) const { return flag ? "on" : "off"; }
    std::string operator()(std::int64_t number) const { return fmt::format("{}", number); }
    std::string operator()(double number) const { return fmt::format("{}", number); }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const glm::vec3& c) const {
      return fmt::format("{},{},{}", c.r, c.g, c.b);
    }
  };
  return std::visit(Format{}, value);
}

double shortestDouble(float number) {
  std::array<char, 32> text{};  // the longest shortest float text has 15 characters
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  double wide = number;
  std::from_chars(text.data(), end, wide);
  return wide;
}

}  // namespace macula::settings
