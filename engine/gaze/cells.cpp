#include "engine/gaze/cells.h"

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
  std::array<char, kLongestNumber> text{};
  std::replace_copy(cell.begin(), cell.end(), text.begin(), ',', '.');
  const char* const end = text.data() + cell.size();
  Real value{};
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || rest != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

void splitCells(std::string_view row, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  while (true) {
    const std::size_t end = row.find(separator);
    cells.push_back(trimmed(row.substr(0, end)));
    if (end == std::string_view::npos) return;
    row.remove_prefix(end + 1);
  }
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

}  // namespace macula::gaze
