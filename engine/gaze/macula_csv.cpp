// Canonical CSV, read and written. The table of its columns stands in README.md of this folder.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "engine/core/error.h"
#include "engine/core/nearest.h"
#include "engine/gaze/cells.h"
#include "engine/gaze/log_format.h"

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
  MaculaCsvParser(std::string_view header, const Place& place) {
    splitCells(header, ',', cells_);
    width_ = cells_.size();
    for (std::size_t cell = 0; cell < width_; ++cell) {
      const auto known = std::find(kColumns.begin(), kColumns.end(), cells_[cell]);
      if (known == kColumns.end()) {
        const std::vector<std::string> names(kColumns.begin(), kColumns.end());
        failInput("{}: line {}: unknown column '{}'; the nearest is '{}'", place.file, place.line,
                  cells_[cell], nearestName(cells_[cell], names));
      }
      std::optional<std::size_t>& index =
          index_[static_cast<std::size_t>(known - kColumns.begin())];
      if (index) {
        failInput("{}: line {}: column '{}' stands twice; keep one", place.file, place.line,
                  cells_[cell]);
      }
      index = cell;
    }
    for (std::size_t column = 0; column < kRequiredColumns; ++column) {
      if (!index_[column]) {
        failInput("{}: line {}: column '{}' is missing; add it", place.file, place.line,
                  kColumns[column]);
      }
    }
  }

  std::optional<std::string> row(std::string_view text, GazeLog& log) override {
    splitCells(text, ',', cells_);
    if (cells_.size() != width_) {
      return fmt::format("{} cells under a header of {}; write '.' as decimal mark, ',' between",
                         cells_.size(), width_);
    }
    const std::optional<double> time = parseNumber(cell(Time));
    if (!time || std::abs(*time) > kLatestTime) return wrong(Time, "seconds");

    GazeSample sample;
    if (cell(Valid) != "0" && cell(Valid) != "1") return wrong(Valid, "0 or 1");
    sample.valid = cell(Valid) == "1";
    // A lost sample may lack its place; half a place, or a valid sample without one, is a mistake.
    if (sample.valid || !absent(X) || !absent(Y)) {
      const std::optional<double> x = parseNumber(cell(X));
      const std::optional<double> y = parseNumber(cell(Y));
      if (!x) return wrong(X, "a number (or make valid 0 and leave x and y empty)");
      if (!y) return wrong(Y, "a number (or make valid 0 and leave x and y empty)");
      sample.position = {*x, *y};
    }
    if (index_[Confidence] && !cell(Confidence).empty()) {
      sample.confidence = parseFloat(cell(Confidence));
      if (!sample.confidence || *sample.confidence < 0.0F || *sample.confidence > 1.0F) {
        return wrong(Confidence, "0..1 or nothing");
      }
    }
    if (index_[Pupil] && !cell(Pupil).empty()) {
      sample.pupilMillimetres = parseFloat(cell(Pupil));
      if (!sample.pupilMillimetres || *sample.pupilMillimetres < 0.0F) {
        return wrong(Pupil, "millimetres or nothing");
      }
    }
    if (log.samples.empty()) log.startSeconds = *time;
    sample.timeSeconds = *time - log.startSeconds;
    log.samples.push_back(sample);
    return std::nullopt;
  }

  void finish(GazeLog& log) override {
    log.coordinates = {.unit = "0..1", .origin = "top left", .screenPixels = std::nullopt};
  }

 private:
  [[nodiscard]] std::string_view cell(Column column) const { return cells_[*index_[column]]; }
  [[nodiscard]] bool absent(Column column) const {
    return cell(column).empty() || cell(column) == "nan";
  }
  [[nodiscard]] std::string wrong(Column column, std::string_view expected) const {
    return fmt::format("{} is '{}'; write {}", kColumns[column], cell(column), expected);
  }

  std::size_t width_ = 0;
  std::array<std::optional<std::size_t>, ColumnCount> index_;
  std::vector<std::string_view> cells_;
};

}  // namespace

bool isMaculaCsv(std::string_view header) {
  std::vector<std::string_view> cells;
  splitCells(header, ',', cells);
  return std::find(cells.begin(), cells.end(), kColumns[Time]) != cells.end();
}

std::unique_ptr<LogParser> openMaculaCsv(std::string_view header, const Place& place) {
  return std::make_unique<MaculaCsvParser>(header, place);
}

std::string canonicalCsv(const GazeLog& log) {
  const auto has = [&](auto member) {
    return std::any_of(log.samples.begin(), log.samples.end(),
                       [&](const GazeSample& s) { return (s.*member).has_value(); });
  };
  const bool confidence = has(&GazeSample::confidence);
  const bool pupil = has(&GazeSample::pupilMillimetres);

  std::string text;
  for (const std::string& note : log.notes) text += "# " + oneLine(note) + "\n";
  text += "time_s,x,y,valid";
  if (confidence) text += ",confidence";
  if (pupil) text += ",pupil_mm";
  text += '\n';
  const auto out = std::back_inserter(text);
  for (const GazeSample& sample : log.samples) {
    const bool placed = std::isfinite(sample.position.x) && std::isfinite(sample.position.y);
    fmt::format_to(out, "{},", sample.timeSeconds);
    if (placed) fmt::format_to(out, "{},{}", sample.position.x, sample.position.y);
    text += placed ? "" : ",";
    text += placed && sample.valid ? ",1" : ",0";
    if (confidence) text += ',';
    if (sample.confidence) fmt::format_to(out, "{}", *sample.confidence);
    if (pupil) text += ',';
    if (sample.pupilMillimetres) fmt::format_to(out, "{}", *sample.pupilMillimetres);
    text += '\n';
  }
  return text;
}

}  // namespace macula::gaze
