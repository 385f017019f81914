// The value of a setting, its range, and how both are read from and shown as text.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace macula::settings {

/// What a setting holds. A choice and a path travel as std::string, a colour as linear R, G, B.
enum class Type : std::uint8_t { Bool, Int, Real, Choice, Text, Path, Colour };

/// Any setting's value: Bool, Int, Real, Choice/Text/Path, Colour in this order.
using Value = std::variant<bool, std::int64_t, double, std::string, glm::vec3>;

/// Bounds of a number, or of each component of a colour. Inclusive unless said otherwise.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  bool minExclusive = false;
  double max = std::numeric_limits<double>::infinity();
  bool maxExclusive = false;

  /// False for NaN and for infinities, whatever the bounds.
  [[nodiscard]] bool holds(double number) const;
  /// "> 0 and <= 4096", ">= 1", "from 1 to 16"; empty without bounds.
  [[nodiscard]] std::string text() const;
};

/// true/false/on/off/1/0, nothing else.
[[nodiscard]] std::optional<bool> parseBool(std::string_view text);
/// The same of a value that a file holds: a boolean, one of these texts, or the number 1 or 0.
[[nodiscard]] std::optional<bool> toBool(const Value& value);
/// How a boolean is written, on a command line and in a file alike, for messages.
inline constexpr std::string_view kBoolForm = "true or false, \"on\" or \"off\", 1 or 0";
/// A whole decimal number of 64 bits with an optional sign; blanks around it are allowed.
[[nodiscard]] std::optional<std::int64_t> parseInt(std::string_view text);
/// A finite decimal number; blanks around it are allowed.
[[nodiscard]] std::optional<double> parseReal(std::string_view text);
/// Three finite numbers with commas between them.
[[nodiscard]] std::optional<glm::vec3> parseColour(std::string_view text);

/// How a share that was written as a percentage is to be written, to be put behind a message:
/// "; write 0.9 for 90 %". Empty where a hundredth of the text, which may end with %, is no such
/// share either.
/// @param range of the share
[[nodiscard]] std::string shareHint(std::string_view text, const Range& range);

/// The text that the parsers above read back as the same value: "on", "4", "0.35", "0,0.5,1".
[[nodiscard]] std::string formatValue(const Value& value);

/// The double with the shortest decimal text that `number` has as a float: 0.35 for 0.35F, where a
/// plain conversion would show 0.3499999940395355 in reports.
[[nodiscard]] double shortestDouble(float number);

}  // namespace macula::settings
