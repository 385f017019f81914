#include "engine/gaze/formats/table_parser.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/error.h"

namespace macula::gaze {
namespace {

constexpr double kLargestPupil = 20.0;

/// How many digits before the decimal mark a number with an exponent does not tell, as 13 in
/// 1.65451E+18; 0 for other numbers.
std::int64_t missingDigits(std::string_view number) {
  const std::size_t e = number.find_first_of("eE");
  if (e == std::string_view::npos) return 0;
  std::string_view exponent = number.substr(e + 1);
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  const std::size_t mark = std::min(number.find_first_of(".,"), e);
  const auto decimals = static_cast<std::int64_t>(e - mark) - (mark < e ? 1 : 0);
  return std::max<std::int64_t>(parseInteger(exponent).value_or(0) - decimals, 0);
}
// Nanoseconds without so many digits are seconds: nothing else is that coarse.
constexpr std::int64_t kMostMissingDigits = 9;

}  // namespace

char separatorOf(std::string_view header) {
  char best = ',';
  std::size_t most = 0;
  std::vector<std::string_view> cells;
  for (const char separator : {',', ';', '\t'}) {
    splitQuotedCells(header, separator, cells);
    if (cells.size() > most) best = separator;
    most = std::max(most, cells.size());
  }
  return best;
}

HeaderCells::HeaderCells(std::string_view header, char separator) {
  splitQuotedCells(header, separator, cells_);
}

bool HeaderCells::has(std::string_view name) const {
  return std::find(cells_.begin(), cells_.end(), name) != cells_.end();
}

bool HeaderCells::hasStart(std::string_view start) const {
  return std::any_of(cells_.begin(), cells_.end(),
                     [&](std::string_view cell) { return cell.starts_with(start); });
}

TableParser::TableParser(std::string_view header, const LogContext& context, char separator)
    : head_(context.head),
      options_(context.options),
      where_(context.where()),
      separator_(separator),
      header_(header) {
  splitQuotedCells(header_, separator, names_);
  // Some rows end with a separator that has no column.
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!names_[i].empty()) width_ = i + 1;
  }
}

TableParser::Column TableParser::find(std::initializer_list<std::string_view> names) const {
  for (const std::string_view name : names) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found != names_.end()) return static_cast<Column>(found - names_.begin());
  }
  return kAbsent;
}

TableParser::Column TableParser::findStart(std::string_view start) const {
  for (Column column = 0; column < names_.size(); ++column) {
    if (names_[column].starts_with(start)) return column;
  }
  return kAbsent;
}

TableParser::Column TableParser::require(std::initializer_list<std::string_view> names) const {
  const Column column = find(names);
  if (column == kAbsent) {
    failInput("{}: column '{}' is missing; export it too", where_, *names.begin());
  }
  return column;
}

bool TableParser::split(std::string_view text, std::string& problem) {
  if (text.find_first_of("\"(") == std::string_view::npos) {
    splitCells(text, separator_, cells_);
  } else {
    splitQuotedCells(text, separator_, cells_);
  }
  // A separator of no column may end a row; a filled cell of none is a decimal comma that split a
  // number, or another slip, and would shift every column behind it.
  const bool fits =
      std::all_of(cells_.begin() + static_cast<std::ptrdiff_t>(std::min(width_, cells_.size())),
                  cells_.end(), [](std::string_view cell) { return cell.empty(); });
  if (cells_.size() >= width_ && fits) return true;
  problem =
      fmt::format("{} under a header of {}; export the log again{}", counted(cells_.size(), "cell"),
                  width_, separator_ == ',' ? ", with '.' as decimal mark" : "");
  return false;
}

Row TableParser::wrong(Column column, std::string_view expected, std::string& problem) const {
  problem = fmt::format("{} is '{}' instead of {}; export the log again", nameOf(column),
                        oneLine(cell(column)), expected);
  return Row::Wrong;
}

std::optional<std::int64_t> TableParser::time(Column column, int digits, std::string_view expected,
                                              std::string& problem) {
  const std::string_view text = cell(column);
  const std::optional<std::int64_t> ticks = parseTicks(text, digits);
  if (!ticks) {
    (void)wrong(column, expected, problem);
    return std::nullopt;
  }
  const std::int64_t missing = missingDigits(text);
  if (missing == 0 && roundedTime_.empty()) return ticks;
  if (missing >= kMostMissingDigits || (missing > 0 && text == roundedTime_)) {
    problem = fmt::format(
        "{} is '{}': a spreadsheet has rounded the times; give the file as the tracker's program "
        "exported it",
        nameOf(column), oneLine(text));
    return std::nullopt;
  }
  roundedTime_ = missing > 0 ? text : std::string_view{};
  return ticks;
}

void TableParser::noteDistance(Column left, Column right, double unitMm) {
  for (const Column column : {left, right}) {
    if (column == kAbsent) continue;
    if (const auto distance = parseNumber(cell(column))) {
      head_.display.noteDistance(*distance * unitMm);
    }
  }
}

std::optional<glm::dvec2> TableParser::pair(Column x, Column y) const {
  const std::optional<double> px = parseNumber(cell(x));
  const std::optional<double> py = parseNumber(cell(y));
  if (!px || !py) return std::nullopt;
  return glm::dvec2(*px, *py);
}

std::optional<double> TableParser::pupil(Column column) const {
  return sanePupil(parseNumber(cell(column)));
}

std::optional<double> sanePupil(const std::optional<double>& millimetres) {
  if (!millimetres || !(*millimetres > 0.0 && *millimetres < kLargestPupil)) return std::nullopt;
  return millimetres;
}

std::optional<glm::dvec2> placeOf(const std::optional<glm::dvec2>& raw,
                                  const CoordinateMapper& mapper, GazeLogHead& head) {
  if (!raw) return std::nullopt;
  const std::optional<glm::dvec2> place = mapper.place(*raw);
  if (!place) ++head.counters.sentinels;
  return place;
}

void placeSample(const std::optional<glm::dvec2>& raw, bool seen, const CoordinateMapper& mapper,
                 GazeLogHead& head, GazeSample& sample) {
  if (seen) {
    if (const auto place = placeOf(raw, mapper, head)) {
      sample.position = *place;
      sample.valid = true;
    }
  } else if (raw) {
    sample.position = mapper.place(*raw).value_or(kNoPosition);
  }
}

void combineEyes(const EyeReading& left, const EyeReading& right,
                 const std::optional<glm::dvec2>& combined, const CoordinateMapper& mapper,
                 GazeLogHead& head, GazeSample& sample) {
  GazeCounters& counters = head.counters;
  ++counters.twoEyeSamples;
  if (!left.seen) ++counters.leftLost;
  if (!right.seen) ++counters.rightLost;
  if (!left.seen && !right.seen) {
    ++counters.bothLost;
    return;
  }
  glm::dvec2 sum{0.0};
  double pupilSum = 0.0;
  int places = 0;
  int pupils = 0;
  for (const EyeReading* const eye : {&left, &right}) {
    if (!eye->seen) continue;
    if (const auto place = placeOf(eye->raw, mapper, head)) {
      sum += *place;
      ++places;
    }
    if (eye->pupil) {
      pupilSum += *eye->pupil;
      ++pupils;
    }
  }
  const std::optional<glm::dvec2> whole = combined ? mapper.place(*combined) : std::nullopt;
  if (!whole && places == 0) return;
  sample.position = whole ? *whole : sum / static_cast<double>(places);
  sample.valid = true;
  if (pupils > 0) sample.pupilMillimetres = static_cast<float>(pupilSum / pupils);
}

}  // namespace macula::gaze
