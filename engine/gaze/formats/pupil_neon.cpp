// Pupil Neon and Invisible: gaze.csv (pixels of the scene camera) and the gaze of a mapped surface.
#include "engine/core/error.h"
#include "engine/gaze/formats/formats.h"
#include "engine/gaze/formats/table_parser.h"

namespace macula::gaze {
namespace {

constexpr std::string_view kTime = "timestamp [ns]";
constexpr std::string_view kPixelX = "gaze x [px]";
constexpr std::string_view kSurfaceX = "gaze position on surface x [normalized]";

bool isTrue(std::string_view cell) {
  return cell == "True" || cell == "true" || cell == "TRUE" || cell == "1" || cell == "1.0";
}

bool isFalse(std::string_view cell) {
  return cell == "False" || cell == "false" || cell == "FALSE" || cell == "0" || cell == "0.0";
}

class PupilNeonParser final : public TableParser {
 public:
  PupilNeonParser(std::string_view header, const LogContext& context)
      : TableParser(header, context),
        surface_(find({kPixelX}) == kAbsent),
        x_(surface_ ? require({kSurfaceX}) : require({kPixelX})),
        y_(surface_ ? require({"gaze position on surface y [normalized]"})
                    : require({"gaze y [px]"})),
        flag_(surface_ ? find({"gaze detected on surface"}) : find({"worn"})),
        mapper_({.unit = surface_ ? GazeUnit::Normalised : GazeUnit::Pixels,
                 .origin = GazeOrigin::TopLeft,
                 .of = surface_ ? "surface" : kSceneCamera,
                 .unitBy = "file"},
                options_, where_),
        clock_(1e9) {
    mapper_.state(head_.coordinates);
  }

  Row row(std::string_view text, GazeSample& sample, std::string& problem) override {
    if (!split(text, problem)) return Row::Wrong;
    const std::optional<std::int64_t> time = this->time(time_, 0, "nanoseconds", problem);
    if (!time) return Row::Wrong;
    if (const auto lack = mapper_.lack()) {
      problem = *lack + " (Neon: 1600x1200, Invisible: 1088x1080)";
      return Row::Wrong;
    }
    const std::string_view flag = cell(flag_);
    if (!flag.empty() && !isTrue(flag) && !isFalse(flag)) {
      return wrong(flag_, "True or False", problem);
    }
    sample.timeSeconds = clock_.seconds(*time, head_);
    // The coordinates of what is lost are kept in the file; they are a guess.
    bool seen = !isFalse(flag);
    const std::string_view blink = cell(blink_);
    if (!blink.empty()) {
      seen = false;
      if (blink != lastBlink_) ++head_.counters.blinks;
    }
    if (blink != lastBlink_) lastBlink_ = blink;
    placeSample(pair(x_, y_), seen, mapper_, head_, sample);
    return Row::Sample;
  }

 private:
  bool surface_;
  Column x_;
  Column y_;
  Column flag_;
  Column time_ = require({kTime});
  Column blink_ = find({"blink id"});
  std::string lastBlink_;
  CoordinateMapper mapper_;
  TickClock clock_;
};

}  // namespace

bool isPupilNeon(std::string_view header, const LogContext& /*context*/) {
  const HeaderCells cells(header);
  return cells.has(kTime) && (cells.has(kPixelX) || cells.has(kSurfaceX));
}

std::unique_ptr<LogParser> openPupilNeon(std::string_view header, const LogContext& context) {
  return std::make_unique<PupilNeonParser>(header, context);
}

}  // namespace macula::gaze
