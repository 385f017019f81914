#include "engine/recording/number_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace macula::recording {
namespace {

/// The longest shortest text of a double has 24 characters.
using Digits = std::array<char, 32>;

template <typename Number>
std::string_view shortest(Number number, Digits& digits) {
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  return {digits.data(), static_cast<std::size_t>(end - digits.data())};
}

/// Whether the number was one without digits, or one whose digits mislead, and was appended.
bool appendSpecial(double number, std::string& text) {
  if (std::isnan(number)) {
    text += "\"nan\"";
  } else if (std::isinf(number)) {
    text += number > 0.0 ? "\"inf\"" : "\"-inf\"";
  } else if (number == 0.0 && std::signbit(number)) {
    text += "-0.0";  // "-0" is a whole number, which has no sign
  } else {
    return false;
  }
  return true;
}

}  // namespace

void appendNumber(double number, std::string& text) {
  Digits digits;
  if (!appendSpecial(number, text)) text += shortest(number, digits);
}

void appendNumber(float number, std::string& text) {
  if (appendSpecial(number, text)) return;
  Digits digits;
  const std::string_view brief = shortest(number, digits);
  double read = 0.0;
  std::from_chars(brief.data(), brief.data() + brief.size(), read);
  // Rounded twice, first to a double, a text close to the middle of two floats can end at the
  // other: 7.038531e-26 does.
  if (static_cast<float>(read) == number) {
    text += brief;
  } else {
    appendNumber(static_cast<double>(number), text);
  }
}

}  // namespace macula::recording
