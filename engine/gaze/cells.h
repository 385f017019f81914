// Cells of a delimited row and the numbers in them. No locale: a file reads the same everywhere.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace macula::gaze {

/// Without spaces at either end.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Splits a row at every separator and trims each cell; n separators make n + 1 cells.
/// @param cells is overwritten; it points into `row`
void splitCells(std::string_view row, char separator, std::vector<std::string_view>& cells);

/// The finite number that the whole cell spells, with '.' or ',' as decimal mark; otherwise
/// nothing.
[[nodiscard]] std::optional<double> parseNumber(std::string_view cell);

/// The same in single precision, rounded once.
[[nodiscard]] std::optional<float> parseFloat(std::string_view cell);

/// The integer that the whole cell spells; otherwise nothing.
[[nodiscard]] std::optional<std::int64_t> parseInteger(std::string_view cell);

}  // namespace macula::gaze
