// What the parsers of delimited tables share: columns by name, cells, eyes.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gaze/cells.h"
#include "engine/gaze/coordinates.h"
#include "engine/gaze/log_format.h"

namespace macula::gaze {

/// What stands between the cells of a header: ',', ';' or a tab, whichever makes the most of them.
/// Spreadsheets write ';' where the decimal mark is a comma.
[[nodiscard]] char separatorOf(std::string_view header);

/// Names of a header's columns, for recognising a format.
class HeaderCells {
 public:
  explicit HeaderCells(std::string_view header) : HeaderCells(header, separatorOf(header)) {}
  HeaderCells(std::string_view header, char separator);
  [[nodiscard]] bool has(std::string_view name) const;
  /// Whether some column begins like this.
  [[nodiscard]] bool hasStart(std::string_view start) const;

 private:
  std::vector<std::string_view> cells_;
};

/// One eye as a row gives it.
struct EyeReading {
  bool seen = false;              ///< by the tracker's flag
  std::optional<glm::dvec2> raw;  ///< in the file's coordinates
  std::optional<double> pupil;    ///< millimetres
};

/// A parser of rows with one separator and columns named by a header.
class TableParser : public LogParser {
 protected:
  using Column = std::size_t;
  static constexpr Column kAbsent = static_cast<Column>(-1);

  TableParser(std::string_view header, const LogContext& context, char separator);
  TableParser(std::string_view header, const LogContext& context)
      : TableParser(header, context, separatorOf(header)) {}

  /// The first of these columns that the file has, or kAbsent.
  [[nodiscard]] Column find(std::initializer_list<std::string_view> names) const;
  /// The first column that begins like this, or kAbsent.
  [[nodiscard]] Column findStart(std::string_view start) const;
  /// The same as find(). @throws InputError naming the first name where there is none
  [[nodiscard]] Column require(std::initializer_list<std::string_view> names) const;

  /// Cuts a row into cells. @returns false, with the problem, where there are too few
  [[nodiscard]] bool split(std::string_view text, std::string& problem);
  /// Empty where the column is absent. Valid after split().
  [[nodiscard]] std::string_view cell(Column column) const {
    return column < cells_.size() ? cells_[column] : std::string_view{};
  }
  /// Empty where the column is absent.
  [[nodiscard]] std::string_view nameOf(Column column) const {
    return column < names_.size() ? names_[column] : std::string_view{};
  }
  /// Sets the problem to "NAME is 'CELL' instead of EXPECTED; export the log again".
  [[nodiscard]] Row wrong(Column column, std::string_view expected, std::string& problem) const;

  /// The time in a cell, as parseTicks() reads it. @returns nothing, with the problem, where it is
  /// none, or where a spreadsheet has rounded it
  /// @param expected what it is counted in, for the problem
  [[nodiscard]] std::optional<std::int64_t> time(Column column, int digits,
                                                 std::string_view expected, std::string& problem);
  /// Notes the eyes' distance from the display. @param unitMm millimetres of the columns' unit
  void noteDistance(Column left, Column right, double unitMm = 1.0);

  /// Two cells as a place; nothing where one holds no number.
  [[nodiscard]] std::optional<glm::dvec2> pair(Column x, Column y) const;
  /// A pupil's diameter in millimetres; nothing where it is none that an eye can have.
  [[nodiscard]] std::optional<double> pupil(Column column) const;

  GazeLogHead& head_;
  const LogOptions& options_;
  const std::string where_;  ///< of the header; begins messages

 private:
  char separator_;
  std::size_t width_ = 0;  ///< cells of a row, without empty ones behind the last name
  std::string header_;
  std::vector<std::string_view> names_;  ///< into header_
  std::vector<std::string_view> cells_;
  std::string roundedTime_;  ///< of the row before, where it was written with an exponent
};

/// Maps a place; a sentinel is counted and gives nothing.
[[nodiscard]] std::optional<glm::dvec2> placeOf(const std::optional<glm::dvec2>& raw,
                                                const CoordinateMapper& mapper, GazeLogHead& head);

/// Sets the place of a sample that has one point: valid where the tracker saw an eye, and kept
/// without being believed where it did not.
void placeSample(const std::optional<glm::dvec2>& raw, bool seen, const CoordinateMapper& mapper,
                 GazeLogHead& head, GazeSample& sample);

/// Sets place, validity and pupil of a sample: the mean of both eyes where both were seen,
/// otherwise the one that was; `combined`, where it is given and a place, goes before the mean. The
/// losses of each eye are counted.
void combineEyes(const EyeReading& left, const EyeReading& right,
                 const std::optional<glm::dvec2>& combined, const CoordinateMapper& mapper,
                 GazeLogHead& head, GazeSample& sample);

/// What keeps other units and rubbish out: a human pupil stays below 10 mm.
[[nodiscard]] std::optional<double> sanePupil(const std::optional<double>& millimetres);

}  // namespace macula::gaze
