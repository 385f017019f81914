// Tobii Studio text export (TSV, one row a sample), as Tobii Studio 1.x to 3.x write it.
#include <cmath>

#include "engine/core/error.h"
#include "engine/gaze/formats/formats.h"
#include "engine/gaze/formats/table_parser.h"
#include "engine/gaze/media_map.h"

namespace macula::gaze {
namespace {

// Validity code of an eye that was not found; 0 to 3 are degrees of certainty which eye it is.
constexpr std::int64_t kEyeNotFound = 4;
constexpr int kMilliToMicro = 3;
// No screen is that wide; larger media are codes or rubbish.
constexpr double kFarthestPixel = 1e6;

class TobiiStudioParser final : public TableParser {
 public:
  TobiiStudioParser(std::string_view header, const LogContext& context)
      : TableParser(header, context),
        mapper_({.unit = GazeUnit::Pixels, .origin = GazeOrigin::TopLeft, .unitBy = "format"},
                options_, where_),
        clock_(1e6) {
    mapper_.state(head_.coordinates);
    if (micro_ == kAbsent && milli_ == kAbsent) {
      failInput(
          "{}: column 'MicroSecondTimestamp' or 'Timestamp' is missing; export one from "
          "Tobii Studio",
          where_);
    }
    given_ = screenOf(options_).has_value();
  }

  [[nodiscard]] bool wantsSurvey() const override { return !given_; }

  void survey(std::string_view text) override {
    std::string problem;
    if (!split(text, problem) || isEvent()) return;
    if (const auto size = resolution()) media_.note({{0.0, 0.0}, *size});
    if (const auto medium = this->medium()) media_.note(*medium);
  }

  Row row(std::string_view text, GazeSample& sample, std::string& problem) override {
    if (!surveyed_) settle();
    if (!split(text, problem)) return Row::Wrong;
    if (isEvent()) {
      ++head_.counters.eventRows;
      return Row::Other;
    }
    EyeReading left{.seen = false, .raw = pair(leftX_, leftY_), .pupil = pupil(leftPupil_)};
    EyeReading right{.seen = false, .raw = pair(rightX_, rightY_), .pupil = pupil(rightPupil_)};
    if (!validity(leftValidity_, left.seen)) return wrong(leftValidity_, "0 to 4", problem);
    if (!validity(rightValidity_, right.seen)) return wrong(rightValidity_, "0 to 4", problem);
    const bool fine = micro_ != kAbsent;
    const std::optional<std::int64_t> time =
        this->time(fine ? micro_ : milli_, fine ? 0 : kMilliToMicro,
                   fine ? "microseconds" : "milliseconds", problem);
    if (!time) return Row::Wrong;
    noteDistance(left.seen ? leftDistance_ : kAbsent, right.seen ? rightDistance_ : kAbsent);
    sample.timeSeconds = clock_.seconds(*time, head_);
    if (!perMedium_) {
      combineEyes(left, right, pair(gazeX_, gazeY_), mapper_, head_, sample);
      return Row::Sample;
    }
    const std::optional<Rectangle> medium = this->medium();
    mapper_.setScreen(medium.value_or(Rectangle{{0.0, 0.0}, {1.0, 1.0}}));
    combineEyes(left, right, pair(gazeX_, gazeY_), mapper_, head_, sample);
    if (!medium) {  // pixels of something unknown are no place
      sample.position = kNoPosition;
      sample.valid = false;
    }
    return Row::Sample;
  }

 private:
  /// After the survey: of what the pixels are.
  void settle() {
    surveyed_ = true;
    if (given_) return;
    if (!media_.any()) {
      failInput(
          "{}: no row gives MediaWidth and MediaHeight; export them from Tobii Studio, or "
          "give --gaze.screen WIDTHxHEIGHT",
          where_);
    }
    if (const std::optional<Rectangle> screen = media_.screen()) {
      mapper_.setScreen(*screen);
      mapper_.state(head_.coordinates);
    } else {
      perMedium_ = true;
      head_.coordinates.of = "medium of each sample";
    }
  }

  /// Rows of events (key, click, media start) lie between the samples and hold no eye.
  [[nodiscard]] bool isEvent() const {
    return cell(leftValidity_).empty() && cell(rightValidity_).empty();
  }

  /// @returns false where the cell is no validity code
  [[nodiscard]] bool validity(Column column, bool& seen) const {
    const std::optional<std::int64_t> code = parseInteger(cell(column));
    if (!code || *code < 0 || *code > kEyeNotFound) return false;
    seen = *code < kEyeNotFound;
    return true;
  }

  [[nodiscard]] std::optional<Rectangle> medium() const {
    const glm::dvec2 origin = {parseNumber(cell(mediaX_)).value_or(0.0),
                               parseNumber(cell(mediaY_)).value_or(0.0)};
    const glm::dvec2 size = pair(mediaWidth_, mediaHeight_).value_or(glm::dvec2(0.0));
    const bool sane = size.x >= 1.0 && size.y >= 1.0 && size.x <= kFarthestPixel &&
                      size.y <= kFarthestPixel && std::abs(origin.x) <= kFarthestPixel &&
                      std::abs(origin.y) <= kFarthestPixel;
    return sane ? std::optional(Rectangle{origin, size}) : std::nullopt;
  }

  /// "1280 x 1024", as version 3 writes the screen.
  [[nodiscard]] std::optional<glm::dvec2> resolution() const {
    const std::string_view text = cell(resolution_);
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) return std::nullopt;
    const auto width = parseInteger(trimmed(text.substr(0, cross)));
    const auto height = parseInteger(trimmed(text.substr(cross + 1)));
    if (!width || !height || *width < 1 || *height < 1) return std::nullopt;
    return glm::dvec2(static_cast<double>(*width), static_cast<double>(*height));
  }

  Column gazeX_ = require({"GazePointX", "GazePointX (ADCSpx)"});
  Column gazeY_ = require({"GazePointY", "GazePointY (ADCSpx)"});
  Column leftValidity_ = require({"ValidityLeft"});
  Column rightValidity_ = require({"ValidityRight"});
  Column leftX_ = find({"GazePointXLeft", "GazePointLeftX (ADCSpx)"});
  Column leftY_ = find({"GazePointYLeft", "GazePointLeftY (ADCSpx)"});
  Column rightX_ = find({"GazePointXRight", "GazePointRightX (ADCSpx)"});
  Column rightY_ = find({"GazePointYRight", "GazePointRightY (ADCSpx)"});
  Column leftPupil_ = find({"PupilLeft"});
  Column rightPupil_ = find({"PupilRight"});
  Column leftDistance_ = find({"DistanceLeft"});
  Column rightDistance_ = find({"DistanceRight"});
  Column micro_ = find({"MicroSecondTimestamp", "EyeTrackerTimestamp"});
  Column milli_ = find({"Timestamp", "RecordingTimestamp"});
  Column mediaX_ = find({"MediaPosX", "MediaPosX (ADCSpx)"});
  Column mediaY_ = find({"MediaPosY", "MediaPosY (ADCSpx)"});
  Column mediaWidth_ = find({"MediaWidth"});
  Column mediaHeight_ = find({"MediaHeight"});
  Column resolution_ = find({"RecordingResolution"});

  CoordinateMapper mapper_;
  TickClock clock_;
  MediaMap media_;
  bool given_ = false;  ///< the screen by a setting
  bool surveyed_ = false;
  bool perMedium_ = false;
};

}  // namespace

bool isTobiiStudio(std::string_view header, const LogContext& /*context*/) {
  const HeaderCells cells(header);
  return cells.has("ValidityLeft") || cells.has("GazePointX") || cells.has("GazePointX (ADCSpx)");
}

std::unique_ptr<LogParser> openTobiiStudio(std::string_view header, const LogContext& context) {
  return std::make_unique<TobiiStudioParser>(header, context);
}

}  // namespace macula::gaze
