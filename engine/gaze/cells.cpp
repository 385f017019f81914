#include "engine/gaze/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace macula::gaze {
namespace {

// The longest double that a program writes in full ("%f" of 1e308) is not gaze; 17 digits, sign,
// mark and exponent need 24 characters.
constexpr std::size_t kLongestNumber = 64;

template <typename Real>
std::optional<Real> parseReal(std::string_view cell) {
  if (cell.empty() || cell.size() > kLongestNumber) return std::nullopt;
  Real value{};
  const char* const end = cell.data() + cell.size();
  auto [rest, error] = std::from_chars(cell.data(), end, value);
  if (error == std::errc{} && rest != end && *rest == ',') {
    std::array<char, kLongestNumber> text;
    std::replace_copy(cell.begin(), cell.end(), text.begin(), ',', '.');
    const char* const textEnd = text.data() + cell.size();
    const auto again = std::from_chars(text.data(), textEnd, value);
    if (again.ec != std::errc{} || again.ptr != textEnd) return std::nullopt;
  } else if (error != std::errc{} || rest != end) {
    return std::nullopt;
  }
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Length of the UTF-8 sequence that the text begins with; 0 where it is none. RFC 3629, section 4:
/// the second byte's range keeps out overlong forms, surrogates and what is beyond U+10FFFF.
std::size_t sequenceLength(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead < 0xC2 || lead > 0xF4) return 0;
  const std::size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (text.size() < length) return 0;
  const unsigned char low = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
  const unsigned char high = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
  if (byte(1) < low || byte(1) > high) return 0;
  for (std::size_t i = 2; i < length; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xBF) return 0;
  }
  return length;
}

std::string_view unquoted(std::string_view cell) {
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
    cell.remove_prefix(1);
    cell.remove_suffix(1);
  }
  return trimmed(cell);
}

/// The same for a number with an exponent, which no clock writes unless a spreadsheet had it.
std::optional<std::int64_t> ticksByDouble(std::string_view cell, int digits) {
  const std::optional<double> number = parseNumber(cell);
  if (!number) return std::nullopt;
  const double scaled = std::round(*number * std::pow(10.0, digits));
  if (!(std::abs(scaled) <= static_cast<double>(kLargestTicks))) return std::nullopt;
  return static_cast<std::int64_t>(scaled);
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  std::size_t first = 0;
  std::size_t last = text.size();
  while (first < last && text[first] == ' ') ++first;
  while (last > first && text[last - 1] == ' ') --last;
  return text.substr(first, last - first);
}

std::string repairedUtf8(std::string_view text) {
  std::string repaired;
  while (!text.empty()) {
    const std::size_t length = sequenceLength(text);
    repaired += length > 0 ? text.substr(0, length) : std::string_view("\xEF\xBF\xBD");
    text.remove_prefix(length > 0 ? length : 1);
  }
  return repaired;
}

void splitCells(std::string_view row, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  // Cells are short: a plain loop is faster than a search for each.
  const char* begin = row.data();
  const char* const end = row.data() + row.size();
  for (const char* at = begin; at != end; ++at) {
    if (*at != separator) continue;
    cells.push_back(trimmed({begin, static_cast<std::size_t>(at - begin)}));
    begin = at + 1;
  }
  cells.push_back(trimmed({begin, static_cast<std::size_t>(end - begin)}));
}

void splitQuotedCells(std::string_view row, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  bool quoted = false;
  bool inside = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const char c = row[i];
    if (c == '"') quoted = !quoted;
    if (c == '(') inside = true;
    if (c == ')') inside = false;
    if (c != separator || quoted || inside) continue;
    cells.push_back(unquoted(trimmed(row.substr(begin, i - begin))));
    begin = i + 1;
  }
  cells.push_back(unquoted(trimmed(row.substr(begin))));
}

void splitWords(std::string_view row, std::vector<std::string_view>& words) {
  words.clear();
  const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
  std::size_t i = 0;
  while (i < row.size()) {
    while (i < row.size() && isBlank(row[i])) ++i;
    const std::size_t begin = i;
    while (i < row.size() && !isBlank(row[i])) ++i;
    if (i > begin) words.push_back(row.substr(begin, i - begin));
  }
}

std::string counted(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::optional<double> parseNumber(std::string_view cell) {
  return parseReal<double>(cell);
}

std::optional<float> parseFloat(std::string_view cell) {
  return parseReal<float>(cell);
}

std::optional<std::int64_t> parseInteger(std::string_view cell) {
  std::int64_t value = 0;
  const char* const end = cell.data() + cell.size();
  const auto [rest, error] = std::from_chars(cell.data(), end, value);
  if (error != std::errc{} || rest != end) return std::nullopt;
  return value;
}

std::optional<std::int64_t> parseTicks(std::string_view cell, int digits) {
  std::size_t i = 0;
  const bool negative = !cell.empty() && cell[0] == '-';
  if (negative) ++i;
  std::int64_t value = 0;
  bool any = false;
  // False where another digit would leave the range.
  const auto push = [&](char digit) {
    if (value > (kLargestTicks - (digit - '0')) / 10) return false;
    value = value * 10 + (digit - '0');
    any = true;
    return true;
  };
  for (; i < cell.size() && isDigit(cell[i]); ++i) {
    if (!push(cell[i])) return std::nullopt;
  }
  int fraction = 0;
  bool roundUp = false;
  if (i < cell.size() && (cell[i] == '.' || cell[i] == ',')) {
    for (++i; i < cell.size() && isDigit(cell[i]); ++i, ++fraction) {
      if (fraction < digits && !push(cell[i])) return std::nullopt;
      if (fraction == digits) roundUp = cell[i] >= '5';
      any = true;
    }
  }
  if (!any) return std::nullopt;
  if (i < cell.size()) return ticksByDouble(cell, digits);
  for (; fraction < digits; ++fraction) {
    if (!push('0')) return std::nullopt;
  }
  value += roundUp ? 1 : 0;
  if (value > kLargestTicks) return std::nullopt;
  return negative ? -value : value;
}

std::optional<NumberPair> parsePair(std::string_view cell) {
  if (cell.size() < 2 || cell.front() != '(' || cell.back() != ')') return std::nullopt;
  cell.remove_prefix(1);
  cell.remove_suffix(1);
  const std::size_t comma = cell.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const std::optional<double> first = parseNumber(trimmed(cell.substr(0, comma)));
  const std::optional<double> second = parseNumber(trimmed(cell.substr(comma + 1)));
  if (!first || !second) return std::nullopt;
  return NumberPair{*first, *second};
}

}  // namespace macula::gaze
