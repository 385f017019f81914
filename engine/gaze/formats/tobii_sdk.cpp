// Gaze data of the Tobii Pro SDK as scripts dump it: one column for each field, points as tuples
// "(x, y)" or as two columns, ';', ',' or tab between.
#include "engine/core/error.h"
#include "engine/gaze/formats/formats.h"
#include "engine/gaze/formats/table_parser.h"

namespace macula::gaze {
namespace {

constexpr std::string_view kLeftPoint = "left_gaze_point_on_display_area";

/// The separator that makes the columns of the format appear; nothing where none does.
std::optional<char> separatorOf(std::string_view header) {
  for (const char separator : {';', ',', '\t'}) {
    if (HeaderCells(header, separator).hasStart(kLeftPoint)) return separator;
  }
  return std::nullopt;
}

class TobiiSdkParser final : public TableParser {
 public:
  TobiiSdkParser(std::string_view header, const LogContext& context)
      : TableParser(header, context, separatorOf(header).value_or(',')),
        mapper_({.unit = GazeUnit::Normalised, .origin = GazeOrigin::TopLeft}, options_, where_),
        clock_(1e6) {
    if (time_ == kAbsent) (void)require({"device_time_stamp"});
    mapper_.state(head_.coordinates);
  }

  Row row(std::string_view text, GazeSample& sample, std::string& problem) override {
    if (!split(text, problem)) return Row::Wrong;
    const std::optional<std::int64_t> time = parseTicks(cell(time_), 0);
    if (!time) return wrong(time_, "microseconds", problem);
    EyeReading eyes[2];
    for (std::size_t i = 0; i < 2; ++i) {
      const Eye& eye = eyes_[i];
      const std::string_view flag = cell(eye.validity);
      if (flag != "0" && flag != "1" && flag != "True" && flag != "False") {
        return wrong(eye.validity, "0 or 1", problem);
      }
      eyes[i].seen = flag == "1" || flag == "True";
      if (eye.tuple != kAbsent) {
        if (const auto point = parsePair(cell(eye.tuple))) {
          eyes[i].raw = glm::dvec2(point->first, point->second);
        } else if (!cell(eye.tuple).ends_with(')') && !cell(eye.tuple).empty()) {
          return wrong(eye.tuple, "(x, y)", problem);
        }
      } else {
        eyes[i].raw = pair(eye.x, eye.y);
      }
      eyes[i].pupil = pupil(eye.pupil);
    }
    sample.timeSeconds = clock_.seconds(*time, head_);
    combineEyes(eyes[0], eyes[1], std::nullopt, mapper_, head_, sample);
    return Row::Sample;
  }

 private:
  struct Eye {
    Column tuple, x, y, validity, pupil;
  };
  // System time is only a stand-in: some scripts round it to 10 ms.
  Column time_ = find({"device_time_stamp", "system_time_stamp"});
  Eye eyes_[2] = {
      eye("left_gaze_point_on_display_area", "left_gaze_point_on_display_area_x",
          "left_gaze_point_on_display_area_y", "left_gaze_point_validity", "left_pupil_diameter"),
      eye("right_gaze_point_on_display_area", "right_gaze_point_on_display_area_x",
          "right_gaze_point_on_display_area_y", "right_gaze_point_validity",
          "right_pupil_diameter")};

  [[nodiscard]] Eye eye(std::string_view tuple, std::string_view x, std::string_view y,
                        std::string_view validity, std::string_view pupil) const {
    Eye columns{find({tuple}), kAbsent, kAbsent, require({validity}), find({pupil})};
    if (columns.tuple == kAbsent) {
      columns.x = require({x});
      columns.y = require({y});
    }
    return columns;
  }

  CoordinateMapper mapper_;
  TickClock clock_;
};

}  // namespace

bool isTobiiSdk(std::string_view header, const LogContext& /*context*/) {
  return separatorOf(header).has_value();
}

std::unique_ptr<LogParser> openTobiiSdk(std::string_view header, const LogContext& context) {
  return std::make_unique<TobiiSdkParser>(header, context);
}

}  // namespace macula::gaze
