// Tobii Studio text export (TSV, one row a sample), as Tobii Studio 1.x and 2.x write it.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "engine/core/error.h"
#include "engine/gaze/cells.h"
#include "engine/gaze/log_format.h"
#include "engine/gaze/media_map.h"

namespace macula::gaze {
namespace {

enum Column : std::size_t {
  MicroSeconds,
  MilliSeconds,
  GazeX,
  GazeY,
  LeftX,
  LeftY,
  LeftPupil,
  LeftValidity,
  RightX,
  RightY,
  RightPupil,
  RightValidity,
  MediaWidth,
  MediaHeight,
  MediaX,
  MediaY,
  ColumnCount
};
constexpr std::array<std::string_view, ColumnCount> kColumns{
    "MicroSecondTimestamp", "Timestamp",       "GazePointX", "GazePointY",
    "GazePointXLeft",       "GazePointYLeft",  "PupilLeft",  "ValidityLeft",
    "GazePointXRight",      "GazePointYRight", "PupilRight", "ValidityRight",
    "MediaWidth",           "MediaHeight",     "MediaPosX",  "MediaPosY"};
constexpr std::array kRequired{GazeX, GazeY, LeftValidity, RightValidity, MediaWidth, MediaHeight};

// Validity code of an eye that was not found; 0 to 3 are degrees of certainty which eye it is.
constexpr std::int64_t kEyeNotFound = 4;
// What the export writes as the place of an eye that was not found, in pixels.
constexpr double kEyeSentinel = -1280.0;
// No screen is that wide; larger coordinates are codes or rubbish.
constexpr double kFarthestPixel = 1e6;
constexpr double kMicroSecondsPerSecond = 1e6;
constexpr double kMicroSecondsPerMilliSecond = 1e3;
// 300 years; beyond it, differences would leave the range of the integer.
constexpr double kLatestMicroSeconds = 1e16;

bool isPlace(const glm::dvec2& pixels) {
  return pixels != glm::dvec2(0.0) && pixels.x != kEyeSentinel && pixels.y != kEyeSentinel &&
         std::abs(pixels.x) <= kFarthestPixel && std::abs(pixels.y) <= kFarthestPixel;
}

class TobiiStudioParser final : public LogParser {
 public:
  TobiiStudioParser(std::string_view header, const Place& place) : file_(place.file) {
    splitCells(header, '\t', cells_);
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
      for (std::size_t column = 0; column < ColumnCount; ++column) {
        if (cells_[cell] == kColumns[column] && !index_[column]) index_[column] = cell;
      }
      if (!cells_[cell].empty()) width_ = cell + 1;  // rows end with a separator of no column
    }
    for (const Column column : kRequired) {
      if (!index_[column]) {
        failInput("{}: line {}: column '{}' is missing; export it from Tobii Studio", place.file,
                  place.line, kColumns[column]);
      }
    }
    if (!index_[MicroSeconds] && !index_[MilliSeconds]) {
      failInput("{}: line {}: column '{}' or '{}' is missing; export one from Tobii Studio",
                place.file, place.line, kColumns[MicroSeconds], kColumns[MilliSeconds]);
    }
  }

  std::optional<std::string> row(std::string_view text, GazeLog& log) override {
    splitCells(text, '\t', cells_);
    if (cells_.size() < width_) {
      return fmt::format("{} cells under a header of {}; export the log again", cells_.size(),
                         width_);
    }
    // Rows of events (key, click, media start) lie between the samples and hold no eye.
    if (cell(LeftValidity).empty() && cell(RightValidity).empty()) {
      ++log.counters.eventRows;
      return std::nullopt;
    }
    const std::optional<std::int64_t> left = validity(LeftValidity);
    const std::optional<std::int64_t> right = validity(RightValidity);
    if (!left) return wrong(LeftValidity, "0 to 4");
    if (!right) return wrong(RightValidity, "0 to 4");
    const Column clock = index_[MicroSeconds] ? MicroSeconds : MilliSeconds;
    const std::optional<std::int64_t> time = microSeconds(clock);
    if (!time) return wrong(clock, clock == MicroSeconds ? "microseconds" : "milliseconds");

    GazeSample sample;
    place(*left < kEyeNotFound, *right < kEyeNotFound, sample);
    if (log.samples.empty()) firstTime_ = *time;
    // From the difference of integers, so that the quotient is rounded only once.
    sample.timeSeconds = static_cast<double>(*time - firstTime_) / kMicroSecondsPerSecond;
    media_.note(log.samples.size(), medium());
    log.samples.push_back(sample);
    return std::nullopt;
  }

  void finish(GazeLog& log) override {
    log.startSeconds = static_cast<double>(firstTime_) / kMicroSecondsPerSecond;
    log.coordinates = {.unit = "px", .origin = "top left", .screenPixels = std::nullopt};
    if (!media_.normalise(log)) {
      failInput(
          "{}: line 1: no row gives MediaWidth and MediaHeight; export them from Tobii Studio",
          file_);
    }
  }

 private:
  [[nodiscard]] std::string_view cell(Column column) const {
    return index_[column] ? cells_[*index_[column]] : std::string_view{};
  }
  [[nodiscard]] std::string wrong(Column column, std::string_view expected) const {
    return fmt::format("{} is '{}' instead of {}; export the log again", kColumns[column],
                       cell(column), expected);
  }
  [[nodiscard]] std::optional<std::int64_t> validity(Column column) const {
    const std::optional<std::int64_t> code = parseInteger(cell(column));
    return code && *code >= 0 && *code <= kEyeNotFound ? code : std::nullopt;
  }
  [[nodiscard]] std::optional<std::int64_t> microSeconds(Column clock) const {
    const std::optional<double> time = parseNumber(cell(clock));
    if (!time) return std::nullopt;
    const double scaled = clock == MicroSeconds ? *time : *time * kMicroSecondsPerMilliSecond;
    if (std::abs(scaled) > kLatestMicroSeconds) return std::nullopt;
    return std::llround(scaled);
  }
  [[nodiscard]] std::optional<glm::dvec2> point(Column x, Column y) const {
    const std::optional<double> px = parseNumber(cell(x));
    const std::optional<double> py = parseNumber(cell(y));
    if (!px || !py || !isPlace({*px, *py})) return std::nullopt;
    return glm::dvec2(*px, *py);
  }

  /// Sets place in pixels, validity and pupil: the combined point where the file has one, otherwise
  /// the mean of the eyes that were seen.
  void place(bool leftSeen, bool rightSeen, GazeSample& sample) const {
    struct Eye {
      bool seen;
      Column x, y, pupil;
    };
    glm::dvec2 sum{0.0};
    double pupilSum = 0.0;
    int places = 0;
    int pupils = 0;
    for (const Eye& eye :
         {Eye{leftSeen, LeftX, LeftY, LeftPupil}, Eye{rightSeen, RightX, RightY, RightPupil}}) {
      if (!eye.seen) continue;
      if (const auto pixels = point(eye.x, eye.y)) {
        sum += *pixels;
        ++places;
      }
      const std::optional<double> pupil = parseNumber(cell(eye.pupil));
      if (pupil && *pupil > 0.0) {
        pupilSum += *pupil;
        ++pupils;
      }
    }
    if (!leftSeen && !rightSeen) return;
    if (const auto combined = point(GazeX, GazeY)) {
      sample.position = *combined;
    } else if (places > 0) {
      sample.position = sum / static_cast<double>(places);
    } else {
      return;
    }
    sample.valid = true;
    const double pupil = pupils > 0 ? pupilSum / pupils : 0.0;
    if (pupil > 0.0 && pupil < kLargestPupil) {
      sample.pupilMillimetres = static_cast<float>(pupil);
    }
  }

  [[nodiscard]] std::optional<Rectangle> medium() const {
    const glm::dvec2 origin{parseNumber(cell(MediaX)).value_or(0.0),
                            parseNumber(cell(MediaY)).value_or(0.0)};
    const glm::dvec2 size{parseNumber(cell(MediaWidth)).value_or(0.0),
                          parseNumber(cell(MediaHeight)).value_or(0.0)};
    const bool sane = size.x >= 1.0 && size.y >= 1.0 && size.x <= kFarthestPixel &&
                      size.y <= kFarthestPixel && std::abs(origin.x) <= kFarthestPixel &&
                      std::abs(origin.y) <= kFarthestPixel;
    return sane ? std::optional(Rectangle{origin, size}) : std::nullopt;
  }

  // A human pupil stays below 10 mm; this only keeps other units and rubbish out.
  static constexpr double kLargestPupil = 20.0;

  std::string file_;
  std::size_t width_ = 0;
  std::array<std::optional<std::size_t>, ColumnCount> index_;
  std::vector<std::string_view> cells_;
  MediaMap media_;
  std::int64_t firstTime_ = 0;
};

}  // namespace

bool isTobiiStudio(std::string_view header) {
  std::vector<std::string_view> cells;
  splitCells(header, '\t', cells);
  const auto has = [&](Column column) {
    for (const std::string_view cell : cells) {
      if (cell == kColumns[column]) return true;
    }
    return false;
  };
  return has(GazeX) || has(LeftValidity);
}

std::unique_ptr<LogParser> openTobiiStudio(std::string_view header, const Place& place) {
  return std::make_unique<TobiiStudioParser>(header, place);
}

}  // namespace macula::gaze
