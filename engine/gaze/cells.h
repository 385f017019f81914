// Cells of a delimited row and the numbers in them. No locale: a file reads the same everywhere.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace macula::gaze {

/// Without spaces at either end.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The text with U+FFFD for each byte that is no UTF-8 (RFC 3629), so that it can go into a report.
[[nodiscard]] std::string repairedUtf8(std::string_view text);

/// Splits a row at every separator and trims each cell; n separators make n + 1 cells.
/// @param cells is overwritten; it points into `row`
void splitCells(std::string_view row, char separator, std::vector<std::string_view>& cells);

/// The same, but separators between double quotes or in parentheses part nothing, and quotes around
/// a cell are taken off.
void splitQuotedCells(std::string_view row, char separator, std::vector<std::string_view>& cells);

/// Splits at any run of spaces and tabs; makes no empty cells.
void splitWords(std::string_view row, std::vector<std::string_view>& words);

/// "1 sample", "2 samples".
[[nodiscard]] std::string counted(std::size_t count, std::string_view thing);

/// The finite number that the whole cell spells, with '.' or ',' as decimal mark; otherwise
/// nothing.
[[nodiscard]] std::optional<double> parseNumber(std::string_view cell);

/// The same in single precision, rounded once.
[[nodiscard]] std::optional<float> parseFloat(std::string_view cell);

/// The integer that the whole cell spells; otherwise nothing.
[[nodiscard]] std::optional<std::int64_t> parseInteger(std::string_view cell);

/// Times that differ by less than this can be subtracted in 64 bits.
inline constexpr std::int64_t kLargestTicks = 4'000'000'000'000'000'000;

/// A decimal number times 10^digits as an integer, without a detour over floating point, so that
/// nanoseconds since 1970 keep every digit; digits beyond those are rounded. '.' or ',' is the
/// decimal mark; an exponent is understood, with the precision of a double.
/// @returns nothing where the cell is no number or the result is beyond kLargestTicks
[[nodiscard]] std::optional<std::int64_t> parseTicks(std::string_view cell, int digits);

/// "(x, y)" as two numbers; nothing where one is missing or not finite.
struct NumberPair {
  double first = 0.0;
  double second = 0.0;
};
[[nodiscard]] std::optional<NumberPair> parsePair(std::string_view cell);

}  // namespace macula::gaze
