// Canonical CSV. The table of its columns stands in README.md of engine/gaze.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/nearest.h"
#include "engine/gaze/canonical_csv.h"
#include "engine/gaze/cells.h"
#include "engine/gaze/coordinates.h"
#include "engine/gaze/formats/formats.h"
#include "engine/gaze/formats/table_parser.h"

namespace macula::gaze {
namespace {

enum Column : std::size_t { Time, X, Y, Valid, Confidence, Pupil, ColumnCount };
constexpr std::size_t kRequiredColumns = Confidence;
constexpr std::array<std::string_view, ColumnCount> kColumns{"time_s", "x",          "y",
                                                             "valid",  "confidence", "pupil_mm"};

// 3,000 years: what is larger is not in seconds.
constexpr double kLatestTime = 1e11;

class MaculaCsvParser final : public LogParser {
 public:
  MaculaCsvParser(std::string_view header, const LogContext& context)
      : head_(context.head), separator_(separatorOf(header)) {
    splitCells(header, separator_, cells_);
    width_ = cells_.size();
    for (std::size_t cell = 0; cell < width_; ++cell) {
      const auto known = std::find(kColumns.begin(), kColumns.end(), cells_[cell]);
      if (known == kColumns.end()) {
        const std::vector<std::string> names(kColumns.begin(), kColumns.end());
        failInput("{}: unknown column '{}'; the nearest is '{}'", context.where(),
                  oneLine(cells_[cell]), nearestName(cells_[cell], names));
      }
      std::optional<std::size_t>& index =
          index_[static_cast<std::size_t>(known - kColumns.begin())];
      if (index) {
        failInput("{}: column '{}' stands twice; keep one", context.where(), cells_[cell]);
      }
      index = cell;
    }
    for (std::size_t column = 0; column < kRequiredColumns; ++column) {
      if (!index_[column]) {
        failInput("{}: column '{}' is missing; add it", context.where(), kColumns[column]);
      }
    }
    // A definition, which no setting overrides. What was converted stays what it was of.
    const bool converted =
        std::any_of(head_.notes.begin(), head_.notes.end(), [](const std::string& note) {
          return note.starts_with(kConverted) && note.find(kSceneCamera) != std::string::npos;
        });
    const CoordinateMapper mapper({.unit = GazeUnit::Normalised,
                                   .origin = GazeOrigin::TopLeft,
                                   .of = converted ? kSceneCamera : "window"},
                                  {}, context.where());
    mapper.state(head_.coordinates);
  }

  Row row(std::string_view text, GazeSample& sample, std::string& problem) override {
    splitCells(text, separator_, cells_);
    if (cells_.size() != width_) {
      problem = fmt::format("{} under a header of {}; write '.' as decimal mark, '{}' between",
                            counted(cells_.size(), "cell"), width_, separator_);
      return Row::Wrong;
    }
    const std::optional<double> time = parseNumber(cell(Time));
    if (!time || std::abs(*time) > kLatestTime) return wrong(Time, "seconds", problem);

    if (cell(Valid) != "0" && cell(Valid) != "1") return wrong(Valid, "0 or 1", problem);
    sample.valid = cell(Valid) == "1";
    // A lost sample may lack its place; half a place, or a valid sample without one, is a mistake.
    if (sample.valid || !absent(X) || !absent(Y)) {
      constexpr std::string_view kNumber = "a number (or make valid 0 and leave x and y empty)";
      const std::optional<double> x = parseNumber(cell(X));
      const std::optional<double> y = parseNumber(cell(Y));
      if (!x) return wrong(X, kNumber, problem);
      if (!y) return wrong(Y, kNumber, problem);
      sample.position = {*x, *y};
    }
    if (index_[Confidence] && !cell(Confidence).empty()) {
      sample.confidence = parseFloat(cell(Confidence));
      if (!sample.confidence || *sample.confidence < 0.0F || *sample.confidence > 1.0F) {
        return wrong(Confidence, "0..1 or nothing", problem);
      }
    }
    if (index_[Pupil] && !cell(Pupil).empty()) {
      sample.pupilMillimetres = parseFloat(cell(Pupil));
      if (!sample.pupilMillimetres || *sample.pupilMillimetres < 0.0F) {
        return wrong(Pupil, "millimetres or nothing", problem);
      }
    }
    if (first_) head_.startSeconds = *time;
    first_ = false;
    sample.timeSeconds = *time - head_.startSeconds;
    return Row::Sample;
  }

 private:
  [[nodiscard]] std::string_view cell(Column column) const { return cells_[*index_[column]]; }
  [[nodiscard]] bool absent(Column column) const {
    return cell(column).empty() || cell(column) == "nan";
  }
  [[nodiscard]] Row wrong(Column column, std::string_view expected, std::string& problem) const {
    problem =
        fmt::format("{} is '{}'; write {}", kColumns[column], oneLine(cell(column)), expected);
    return Row::Wrong;
  }

  GazeLogHead& head_;
  char separator_;
  bool first_ = true;
  std::size_t width_ = 0;
  std::array<std::optional<std::size_t>, ColumnCount> index_;
  std::vector<std::string_view> cells_;
};

}  // namespace

bool isMaculaCsv(std::string_view header, const LogContext& /*context*/) {
  std::vector<std::string_view> cells;
  splitCells(header, separatorOf(header), cells);
  return std::find(cells.begin(), cells.end(), kColumns[Time]) != cells.end();
}

std::unique_ptr<LogParser> openMaculaCsv(std::string_view header, const LogContext& context) {
  return std::make_unique<MaculaCsvParser>(header, context);
}

}  // namespace macula::gaze
