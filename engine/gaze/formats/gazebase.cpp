// GazeBase (Griffith et al. 2021): one CSV a recording, milliseconds and degrees.
#include "engine/gaze/formats/formats.h"
#include "engine/gaze/formats/table_parser.h"

namespace macula::gaze {
namespace {

constexpr int kMilliToMicro = 3;

class GazeBaseParser final : public TableParser {
 public:
  GazeBaseParser(std::string_view header, const LogContext& context)
      : TableParser(header, context),
        // y points up: the reading tasks begin at the upper left, where y is positive.
        mapper_({.unit = GazeUnit::Degrees, .origin = GazeOrigin::CentreUp}, options_, where_),
        clock_(1e6) {
    mapper_.state(head_.coordinates);
  }

  Row row(std::string_view text, GazeSample& sample, std::string& problem) override {
    if (!split(text, problem)) return Row::Wrong;
    const std::optional<std::int64_t> time =
        this->time(time_, kMilliToMicro, "milliseconds", problem);
    if (!time) return Row::Wrong;
    const std::optional<double> code = parseNumber(cell(valid_));
    if (!code) return wrong(valid_, "0 where the eye was seen", problem);
    if (const auto lack = mapper_.lack()) {
      problem = *lack;
      return Row::Wrong;
    }
    sample.timeSeconds = clock_.seconds(*time, head_);
    if (*code != 0.0) return Row::Sample;
    if (const auto place = placeOf(pair(x_, y_), mapper_, head_)) {
      sample.position = *place;
      sample.valid = true;
    }
    return Row::Sample;
  }

 private:
  Column time_ = require({"n"});
  Column x_ = require({"x"});
  Column y_ = require({"y"});
  Column valid_ = require({"val"});
  CoordinateMapper mapper_;
  TickClock clock_;
};

}  // namespace

bool isGazeBase(std::string_view header, const LogContext& /*context*/) {
  const HeaderCells cells(header);
  return cells.has("n") && cells.has("x") && cells.has("y") && cells.has("val");
}

std::unique_ptr<LogParser> openGazeBase(std::string_view header, const LogContext& context) {
  return std::make_unique<GazeBaseParser>(header, context);
}

}  // namespace macula::gaze
