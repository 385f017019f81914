// Tobii Pro Lab data export (TSV): samples of the eye tracker between rows of other sensors and of
// events. Later versions write units into the names of the columns.
#include "engine/core/error.h"
#include "engine/gaze/formats/formats.h"
#include "engine/gaze/formats/table_parser.h"

namespace macula::gaze {
namespace {

struct TimeColumn {
  std::string_view name;
  TimeUnit unit;
};
// Micro as the Greek letter, as the sign of Latin-1, and in ASCII.
constexpr TimeColumn kTimes[] = {{"Recording timestamp [\xCE\xBCs]", TimeUnit::Microseconds},
                                 {"Recording timestamp [\xC2\xB5s]", TimeUnit::Microseconds},
                                 {"Recording timestamp [us]", TimeUnit::Microseconds},
                                 {"Recording timestamp [ms]", TimeUnit::Milliseconds},
                                 {"Recording timestamp", TimeUnit::File}};

class TobiiProLabParser final : public TableParser {
 public:
  TobiiProLabParser(std::string_view header, const LogContext& context)
      : TableParser(header, context, '\t'), mapper_(coordinates(), options_, where_) {
    for (const TimeColumn& candidate : kTimes) {
      time_ = find({candidate.name});
      unit_ = candidate.unit;
      if (time_ != kAbsent) break;
    }
    if (time_ == kAbsent) (void)require({"Recording timestamp [ms]"});
    if (options_.timeUnit != TimeUnit::File) unit_ = options_.timeUnit;
    if (unit_ == TimeUnit::File) {
      failInput("{}: 'Recording timestamp' has no unit; give --gaze.timeUnit ms or us", where_);
    }
    clock_ = TickClock(ticksPerSecond(TimeUnit::Nanoseconds));
    if (leftValidity_ == kAbsent && gazeX_ == kAbsent) (void)require({"Gaze point X [DACS px]"});
    if (sensor_ == kAbsent && leftValidity_ == kAbsent) (void)require({"Validity left"});
    mapper_.state(head_.coordinates);
  }

  Row row(std::string_view text, GazeSample& sample, std::string& problem) override {
    if (!split(text, problem)) return Row::Wrong;
    if (isEvent()) {
      ++head_.counters.eventRows;
      return Row::Other;
    }
    // Nanoseconds keep every digit of either unit.
    const std::optional<std::int64_t> time = nanoseconds();
    if (!time) return wrong(time_, "a time", problem);
    if (mapper_.lack()) {
      if (const auto size = pair(width_, height_); size && size->x >= 1.0 && size->y >= 1.0) {
        mapper_.setScreen({{0.0, 0.0}, *size});
        mapper_.state(head_.coordinates);
      } else {
        problem = *mapper_.lack();
        return Row::Wrong;
      }
    }
    sample.timeSeconds = clock_.seconds(*time, head_);
    const std::optional<glm::dvec2> combined = pair(gazeX_, gazeY_);
    if (leftValidity_ == kAbsent) {  // only the combined point was exported
      if (const auto place = placeOf(combined, mapper_, head_)) {
        sample.position = *place;
        sample.valid = true;
      }
      return Row::Sample;
    }
    combineEyes({cell(leftValidity_) == "Valid", pair(leftX_, leftY_), pupil(leftPupil_)},
                {cell(rightValidity_) == "Valid", pair(rightX_, rightY_), pupil(rightPupil_)},
                combined, mapper_, head_, sample);
    return Row::Sample;
  }

 private:
  /// The display's pixels, or, where only those of the medium were exported, its 0..1.
  Coordinates coordinates() {
    for (const bool suffixed : {true, false}) {
      gazeX_ = suffixed ? find({"Gaze point X [DACS px]"}) : find({"Gaze point X"});
      gazeY_ = suffixed ? find({"Gaze point Y [DACS px]"}) : find({"Gaze point Y"});
      leftX_ = suffixed ? find({"Gaze point left X [DACS px]"}) : find({"Gaze point left X"});
      leftY_ = suffixed ? find({"Gaze point left Y [DACS px]"}) : find({"Gaze point left Y"});
      rightX_ = suffixed ? find({"Gaze point right X [DACS px]"}) : find({"Gaze point right X"});
      rightY_ = suffixed ? find({"Gaze point right Y [DACS px]"}) : find({"Gaze point right Y"});
      if (gazeX_ != kAbsent || leftX_ != kAbsent) {
        return {.unit = GazeUnit::Pixels,
                .origin = GazeOrigin::TopLeft,
                .unitBy = suffixed ? "file" : "format"};
      }
    }
    gazeX_ = find({"Gaze point X [MCS norm]"});
    gazeY_ = find({"Gaze point Y [MCS norm]"});
    leftX_ = find({"Gaze point left X [MCS norm]"});
    leftY_ = find({"Gaze point left Y [MCS norm]"});
    rightX_ = find({"Gaze point right X [MCS norm]"});
    rightY_ = find({"Gaze point right Y [MCS norm]"});
    if (gazeX_ == kAbsent && leftX_ == kAbsent) (void)require({"Gaze point X [DACS px]"});
    return {.unit = GazeUnit::Normalised,
            .origin = GazeOrigin::TopLeft,
            .of = "medium",
            .unitBy = "file"};
  }

  /// Other sensors (mouse, GSR) have their own rows; events have no sensor.
  [[nodiscard]] bool isEvent() const {
    if (sensor_ != kAbsent) return cell(sensor_) != "Eye Tracker";
    return cell(leftValidity_).empty() && cell(rightValidity_).empty();
  }

  [[nodiscard]] std::optional<std::int64_t> nanoseconds() const {
    return parseTicks(cell(time_), digitsOf(TimeUnit::Nanoseconds) - digitsOf(unit_));
  }

  Column time_ = kAbsent;
  TimeUnit unit_ = TimeUnit::File;
  Column sensor_ = find({"Sensor"});
  Column gazeX_ = kAbsent;
  Column gazeY_ = kAbsent;
  Column leftX_ = kAbsent;
  Column leftY_ = kAbsent;
  Column rightX_ = kAbsent;
  Column rightY_ = kAbsent;
  Column leftValidity_ = find({"Validity left"});
  Column rightValidity_ = find({"Validity right"});
  Column leftPupil_ = find({"Pupil diameter left [mm]", "Pupil diameter left"});
  Column rightPupil_ = find({"Pupil diameter right [mm]", "Pupil diameter right"});
  Column width_ = find({"Recording resolution width [px]", "Recording resolution width"});
  Column height_ = find({"Recording resolution height [px]", "Recording resolution height"});
  CoordinateMapper mapper_;
  TickClock clock_;
};

}  // namespace

bool isTobiiProLab(std::string_view header, const LogContext& /*context*/) {
  const HeaderCells cells(header, '\t');
  return cells.hasStart("Recording timestamp") && cells.hasStart("Gaze point ");
}

std::unique_ptr<LogParser> openTobiiProLab(std::string_view header, const LogContext& context) {
  return std::make_unique<TobiiProLabParser>(header, context);
}

}  // namespace macula::gaze
