// Gaze data of the Tobii Pro SDK as scripts dump it: one column for each field, points as tuples
// "(x, y)" or as two columns, ';', ',' or tab between.
#include "engine/core/error.h"
#include "engine/gaze/formats/formats.h"
#include "engine/gaze/formats/table_parser.h"

namespace macula::gaze {
namespace {

constexpr std::string_view kLeftPoint = "left_gaze_point_on_display_area";

/// Millimetres towards the viewer in "(x, y, z)"; nothing where there are none.
std::optional<double> depthOf(std::string_view tuple) {
  const std::size_t comma = tuple.rfind(',');
  if (comma == std::string_view::npos || !tuple.ends_with(')')) return std::nullopt;
  return parseNumber(trimmed(tuple.substr(comma + 1, tuple.size() - comma - 2)));
}

class TobiiSdkParser final : public TableParser {
 public:
  TobiiSdkParser(std::string_view header, const LogContext& context)
      : TableParser(header, context),
        mapper_({.unit = GazeUnit::Normalised, .origin = GazeOrigin::TopLeft}, options_, where_),
        clock_(1e6) {
    if (time_ == kAbsent) (void)require({"device_time_stamp"});
    mapper_.state(head_.coordinates);
  }

  Row row(std::string_view text, GazeSample& sample, std::string& problem) override {
    if (!split(text, problem)) return Row::Wrong;
    const std::optional<std::int64_t> time = this->time(time_, 0, "microseconds", problem);
    if (!time) return Row::Wrong;
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
      if (eyes[i].seen) {
        noteDistance(eye.z, kAbsent);
        if (const auto depth = depthOf(cell(eye.origin))) head_.display.noteDistance(*depth);
      }
    }
    sample.timeSeconds = clock_.seconds(*time, head_);
    combineEyes(eyes[0], eyes[1], std::nullopt, mapper_, head_, sample);
    return Row::Sample;
  }

 private:
  struct Eye {
    Column tuple, x, y, validity, pupil;
    Column origin, z;  ///< of the eye, before the tracker
  };
  // System time is only a stand-in: some scripts round it to 10 ms.
  Column time_ = find({"device_time_stamp", "system_time_stamp"});
  Eye eyes_[2] = {eye("left_gaze_point_on_display_area", "left_gaze_point_on_display_area_x",
                      "left_gaze_point_on_display_area_y", "left_gaze_point_validity",
                      "left_pupil_diameter", "left_gaze_origin_in_user_coordinate_system",
                      "left_gaze_origin_in_user_coordinate_system_z"),
                  eye("right_gaze_point_on_display_area", "right_gaze_point_on_display_area_x",
                      "right_gaze_point_on_display_area_y", "right_gaze_point_validity",
                      "right_pupil_diameter", "right_gaze_origin_in_user_coordinate_system",
                      "right_gaze_origin_in_user_coordinate_system_z")};

  [[nodiscard]] Eye eye(std::string_view tuple, std::string_view x, std::string_view y,
                        std::string_view validity, std::string_view pupil, std::string_view origin,
                        std::string_view z) const {
    Eye columns{find({tuple}), kAbsent,        kAbsent,  require({validity}),
                find({pupil}), find({origin}), find({z})};
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
  return HeaderCells(header).hasStart(kLeftPoint);
}

std::unique_ptr<LogParser> openTobiiSdk(std::string_view header, const LogContext& context) {
  return std::make_unique<TobiiSdkParser>(header, context);
}

}  // namespace macula::gaze
