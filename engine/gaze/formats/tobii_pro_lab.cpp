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
      : TableParser(header, context), mapper_(coordinates(), options_, where_) {
    for (const TimeColumn& candidate : kTimes) {
      time_ = find({candidate.name});
      unit_ = candidate.unit;
      if (time_ != kAbsent) break;
    }
    if (time_ == kAbsent) (void)require({"Recording timestamp [ms]"});
    if (gazeX_ != kAbsent && gazeY_ == kAbsent) (void)require({"Gaze point Y"});
    if (options_.timeUnit != TimeUnit::File) unit_ = options_.timeUnit;
    if (unit_ == TimeUnit::File) {
      failInput("{}: 'Recording timestamp' has no unit; give --gaze.timeUnit ms or us", where_);
    }
    clock_ = TickClock(ticksPerSecond(TimeUnit::Nanoseconds));
    if (leftValidity_ == kAbsent && gazeX_ == kAbsent) (void)require({"Gaze point X"});
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
    const std::optional<std::int64_t> time =
        this->time(time_, digitsOf(TimeUnit::Nanoseconds) - digitsOf(unit_), "a time", problem);
    if (!time) return Row::Wrong;
    if (!settled_) settle();
    if (const auto lack = mapper_.lack()) {
      problem = *lack;
      return Row::Wrong;
    }
    noteDistance(leftZ_, rightZ_);
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
  /// At the first sample: how large that is which the pixels are of. Glasses have no screen; their
  /// recordings are of the scene camera.
  void settle() {
    settled_ = true;
    const auto sizeIn = [&](Column width, Column height) {
      const auto size = pair(width, height);
      return size && size->x >= 1.0 && size->y >= 1.0 ? size : std::nullopt;
    };
    const std::optional<glm::dvec2> screen = sizeIn(width_, height_);
    const std::optional<glm::dvec2> video = sizeIn(videoWidth_, videoHeight_);
    if (of_ == "screen" && !suffixed_ && !screen && video) {
      of_ = kSceneCamera;
      mapper_.setOf(of_);
    }
    const std::optional<glm::dvec2> size = of_ == "screen"       ? screen
                                           : of_ == kSceneCamera ? video
                                                                 : std::nullopt;
    if (size) mapper_.setScreen({{0.0, 0.0}, *size});
    mapper_.state(head_.coordinates);
  }

  /// Finds the columns of gaze whose names end like this.
  bool findGaze(std::string_view suffix) {
    const auto column = [&](std::string name) { return find({name.append(suffix)}); };
    gazeX_ = column("Gaze point X");
    gazeY_ = column("Gaze point Y");
    leftX_ = column("Gaze point left X");
    leftY_ = column("Gaze point left Y");
    rightX_ = column("Gaze point right X");
    rightY_ = column("Gaze point right Y");
    return gazeX_ != kAbsent || leftX_ != kAbsent;
  }

  /// The display's pixels, or, where only those of the medium were exported, its own pixels or
  /// 0..1.
  Coordinates coordinates() {
    for (const std::string_view suffix : {" [DACS px]", ""}) {
      if (!findGaze(suffix)) continue;
      suffixed_ = !suffix.empty();
      return {.unit = GazeUnit::Pixels,
              .origin = GazeOrigin::TopLeft,
              .unitBy = suffixed_ ? "file" : "format"};
    }
    const bool pixels = findGaze(" [MCS px]");
    if (!pixels && !findGaze(" [MCS norm]")) (void)require({"Gaze point X"});
    suffixed_ = true;
    of_ = videoWidth_ != kAbsent && width_ == kAbsent ? kSceneCamera : "medium";
    return {.unit = pixels ? GazeUnit::Pixels : GazeUnit::Normalised,
            .origin = GazeOrigin::TopLeft,
            .of = of_,
            .unitBy = "file"};
  }

  /// Other sensors (mouse, GSR) have their own rows; events have no sensor.
  [[nodiscard]] bool isEvent() const {
    if (sensor_ != kAbsent) return cell(sensor_) != "Eye Tracker";
    return cell(leftValidity_).empty() && cell(rightValidity_).empty();
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
  Column videoWidth_ = find({"Recording media width [px]", "Recording media width"});
  Column videoHeight_ = find({"Recording media height [px]", "Recording media height"});
  Column leftZ_ = findStart("Eye position left Z");  // millimetres from the display
  Column rightZ_ = findStart("Eye position right Z");
  std::string_view of_ = "screen";
  bool suffixed_ = false;  ///< the columns say of what they are
  bool settled_ = false;   ///< settle() was called
  CoordinateMapper mapper_;
  TickClock clock_;
};

}  // namespace

bool isTobiiProLab(std::string_view header, const LogContext& /*context*/) {
  const HeaderCells cells(header);
  return cells.hasStart("Recording timestamp") &&
         (cells.hasStart("Gaze point ") || cells.has("Sensor"));
}

std::unique_ptr<LogParser> openTobiiProLab(std::string_view header, const LogContext& context) {
  return std::make_unique<TobiiProLabParser>(header, context);
}

}  // namespace macula::gaze
