// Gazepoint's all_gaze CSV (Gazepoint Analysis; the fields of the Open Gaze API).
#include <algorithm>
#include <cstdlib>

#include "engine/core/error.h"
#include "engine/gaze/formats/formats.h"
#include "engine/gaze/formats/table_parser.h"

namespace macula::gaze {
namespace {

constexpr int kNanoDigits = 9;

class GazepointParser final : public TableParser {
 public:
  GazepointParser(std::string_view header, const LogContext& context)
      : TableParser(header, context),
        mapper_({.unit = GazeUnit::Normalised, .origin = GazeOrigin::TopLeft}, options_, where_),
        clock_(frequency()) {
    if (tick_ == kAbsent && time_ == kAbsent) (void)require({"TIME"});
    if (!best_) {
      head_.notes.emplace_back("reader: only the tracker's fixation filter (FPOG) is in the file");
    }
    if (tick_ == kAbsent) {
      head_.notes.emplace_back("reader: no TIMETICK; TIME is carried on where it restarts");
    }
    mapper_.state(head_.coordinates);
  }

  Row row(std::string_view text, GazeSample& sample, std::string& problem) override {
    if (!split(text, problem)) return Row::Wrong;
    const Column clock = tick_ != kAbsent ? tick_ : time_;
    const bool ticks = tick_ != kAbsent;
    const std::optional<std::int64_t> read =
        this->time(clock, ticks ? 0 : kNanoDigits, ticks ? "ticks" : "seconds", problem);
    if (!read) return Row::Wrong;
    const std::string_view flag = cell(valid_);
    if (flag != "0" && flag != "1") return wrong(valid_, "0 or 1", problem);

    const std::optional<std::int64_t> time = carriedOn(*read);
    if (!time) return wrong(clock, "a time that does not run away", problem);
    sample.timeSeconds = clock_.seconds(*time, head_);
    countBlink();
    noteDistance(leftEyeZ_, rightEyeZ_, kMetre);
    if (leftValid_ != kAbsent && rightValid_ != kAbsent) countEyes();
    const std::optional<glm::dvec2> raw = pair(x_, y_);
    if (flag == "1") {
      if (const auto place = placeOf(raw, mapper_, head_)) {
        sample.position = *place;
        sample.valid = true;
      }
      readPupils(sample);
    } else if (raw) {  // frozen at the last place
      sample.position = mapper_.place(*raw).value_or(kNoPosition);
    }
    return Row::Sample;
  }

 private:
  /// "TIMETICK(f=10000000)" has its frequency in its name; TIME is read in nanoseconds.
  [[nodiscard]] double frequency() const {
    if (tick_ == kAbsent) return 1e9;
    std::string_view name = nameOf(tick_);
    const std::size_t begin = name.find("f=");
    const std::size_t end = name.find(')');
    std::optional<std::int64_t> hertz;
    if (begin != std::string_view::npos && end != std::string_view::npos && end > begin) {
      hertz = parseInteger(name.substr(begin + 2, end - begin - 2));
    }
    if (!hertz || *hertz <= 0) {
      failInput("{}: '{}' has no frequency; export TIMETICK(f=10000000)", where_,
                oneLine(nameOf(tick_)));
    }
    return static_cast<double>(*hertz);
  }

  /// TIME begins again with each medium: then the clock goes on by the interval before. TIMETICK
  /// does not. Nothing where restarts have added up to more than a clock can hold.
  std::optional<std::int64_t> carriedOn(std::int64_t time) {
    if (tick_ != kAbsent) return time;
    if (std::abs(time) > kLargestTicks / 4) return std::nullopt;
    const std::string_view medium = cell(medium_);
    if (last_ && time < *last_ && medium != lastMedium_) {
      ++head_.counters.clockRestarts;
      offset_ += *last_ + interval_ - time;
    } else if (last_ && time > *last_) {
      interval_ = time - *last_;
    }
    if (medium != lastMedium_) lastMedium_ = medium;
    last_ = time;
    if (std::abs(offset_) > kLargestTicks / 2) return std::nullopt;
    return time + offset_;
  }

  /// BKID numbers the blinks and is 0 between them.
  void countBlink() {
    const std::string_view blink = cell(blink_);
    if (blink == lastBlink_) return;
    lastBlink_ = blink;
    if (!blink.empty() && blink != "0") ++head_.counters.blinks;
  }

  void countEyes() {
    const bool left = cell(leftValid_) == "1";
    const bool right = cell(rightValid_) == "1";
    ++head_.counters.twoEyeSamples;
    if (!left) ++head_.counters.leftLost;
    if (!right) ++head_.counters.rightLost;
    if (!left && !right) ++head_.counters.bothLost;
  }

  /// LPMM and RPMM are in millimetres, whatever their valid flags say.
  void readPupils(GazeSample& sample) const {
    double sum = 0.0;
    int count = 0;
    const auto add = [&](Column column, Column valid) {
      const std::optional<double> diameter = pupil(column);
      if (!diameter || cell(valid) == "0") return;
      sum += *diameter;
      ++count;
    };
    add(leftPupil_, leftPupilValid_);
    add(rightPupil_, rightPupilValid_);
    if (count > 0) sample.pupilMillimetres = static_cast<float>(sum / count);
  }

  Column tick_ = findStart("TIMETICK");
  Column time_ = std::min(findStart("TIME("), find({"TIME", "Time (in secs)"}));
  Column medium_ = find({"MEDIA_ID"});
  // The best point of gaze of each sample; that of the fixation is filtered by the tracker.
  bool best_ = find({"FPOGX"}) == kAbsent || find({"BPOGX"}) != kAbsent;
  Column x_ = require({best_ ? "BPOGX" : "FPOGX"});
  Column y_ = require({best_ ? "BPOGY" : "FPOGY"});
  Column valid_ = require({best_ ? "BPOGV" : "FPOGV"});
  Column leftValid_ = find({"LPOGV", "LPV"});
  Column rightValid_ = find({"RPOGV", "RPV"});
  Column blink_ = find({"BKID"});
  Column leftPupil_ = find({"LPMM"});
  Column rightPupil_ = find({"RPMM"});
  Column leftPupilValid_ = find({"LPMMV"});
  Column rightPupilValid_ = find({"RPMMV"});

  // Metres from the camera below the screen.
  static constexpr double kMetre = 1000.0;
  Column leftEyeZ_ = find({"LEYEZ"});
  Column rightEyeZ_ = find({"REYEZ"});

  std::optional<std::int64_t> last_;
  std::int64_t interval_ = 0;
  std::int64_t offset_ = 0;
  std::string lastMedium_;
  std::string lastBlink_ = "0";
  CoordinateMapper mapper_;
  TickClock clock_;
};

}  // namespace

bool isGazepoint(std::string_view header, const LogContext& /*context*/) {
  const HeaderCells cells(header);
  return (cells.hasStart("TIMETICK") || cells.hasStart("TIME(") || cells.has("TIME")) &&
         (cells.has("BPOGX") || cells.has("FPOGX"));
}

std::unique_ptr<LogParser> openGazepoint(std::string_view header, const LogContext& context) {
  return std::make_unique<GazepointParser>(header, context);
}

}  // namespace macula::gaze
