// Pupil Core's gaze_positions.csv (of the world camera) and gaze_positions_on_surface_NAME.csv.
#include "engine/core/error.h"
#include "engine/gaze/formats/formats.h"
#include "engine/gaze/formats/table_parser.h"

namespace macula::gaze {
namespace {

constexpr int kNanoDigits = 9;

class PupilCoreParser final : public TableParser {
 public:
  PupilCoreParser(std::string_view header, const LogContext& context)
      : TableParser(header, context),
        surface_(find({"norm_pos_x"}) == kAbsent),
        x_(surface_ ? require({"x_norm"}) : require({"norm_pos_x"})),
        y_(surface_ ? require({"y_norm"}) : require({"norm_pos_y"})),
        mapper_({.unit = GazeUnit::Normalised,
                 .origin = GazeOrigin::BottomLeft,
                 .of = surface_ ? "surface" : kSceneCamera},
                options_, where_),
        clock_(1e9) {
    // Positions of the pupils in the eye cameras have the same columns and are not gaze.
    if (find({"ellipse_center_x", "eye_id"}) != kAbsent) {
      failInput("{}: positions of pupils, not of gaze; give gaze_positions.csv", where_);
    }
    mapper_.state(head_.coordinates);
  }

  Row row(std::string_view text, GazeSample& sample, std::string& problem) override {
    if (!split(text, problem)) return Row::Wrong;
    // Nanoseconds: the clock has about that many digits.
    const std::optional<std::int64_t> time = this->time(time_, kNanoDigits, "seconds", problem);
    if (!time) return Row::Wrong;
    const std::optional<double> confidence = parseNumber(cell(confidence_));
    if (!confidence || *confidence < 0.0 || *confidence > 1.0) {
      return wrong(confidence_, "0..1", problem);
    }
    sample.timeSeconds = clock_.seconds(*time, head_);
    sample.confidence = static_cast<float>(*confidence);
    const bool trusted = *confidence >= options_.minConfidence;
    placeSample(pair(x_, y_), trusted, mapper_, head_, sample);
    return Row::Sample;
  }

 private:
  bool surface_;
  Column x_;
  Column y_;
  Column time_ = require({"gaze_timestamp", "timestamp"});
  Column confidence_ = require({"confidence"});
  CoordinateMapper mapper_;
  TickClock clock_;
};

}  // namespace

bool isPupilCore(std::string_view header, const LogContext& /*context*/) {
  const HeaderCells cells(header);
  return (cells.has("norm_pos_x") && (cells.has("gaze_timestamp") || cells.has("timestamp"))) ||
         (cells.has("x_norm") && cells.has("on_surf"));
}

std::unique_ptr<LogParser> openPupilCore(std::string_view header, const LogContext& context) {
  return std::make_unique<PupilCoreParser>(header, context);
}

}  // namespace macula::gaze
