// BIDS eye tracking (physio.tsv or .tsv.gz): rows without a header, described by a JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/gaze/formats/formats.h"
#include "engine/gaze/formats/table_parser.h"

namespace macula::gaze {
namespace {

using Json = nlohmann::json;

Json parseJson(std::string_view text) {
  return Json::parse(text, nullptr, false);
}

/// The column names of a sidecar, tabs between, as a header would give them; empty where it is no
/// sidecar of a recording.
std::string headerOf(const Json& json) {
  if (!json.is_object() || !json.contains("Columns") || !json["Columns"].is_array()) return {};
  std::string header;
  for (const Json& name : json["Columns"]) {
    if (!name.is_string()) return {};
    header += (header.empty() ? "" : "\t") + oneLine(name.get<std::string>());
  }
  return header;
}

/// Text of a field, or of the first two of an array joined ("top" and "left"); lower case.
std::string textOf(const Json& json, std::string_view key) {
  const auto found = json.find(key);
  if (found == json.end()) return {};
  std::string text;
  if (found->is_string()) text = found->get<std::string>();
  if (found->is_array()) {
    for (const Json& part : *found) {
      if (part.is_string()) text += (text.empty() ? "" : " ") + part.get<std::string>();
    }
  }
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '-' || c == '_') c = ' ';
  }
  return text;
}

bool mentions(const std::string& text, std::string_view word) {
  return text.find(word) != std::string::npos;
}

GazeUnit unitNamed(const std::string& text) {
  if (text == "px" || text.starts_with("pixel")) return GazeUnit::Pixels;
  if (text.starts_with("deg") || mentions(text, "visual angle")) return GazeUnit::Degrees;
  if (text == "0..1" || text == "normalized" || text == "normalised") return GazeUnit::Normalised;
  return GazeUnit::File;
}

GazeOrigin originNamed(const std::string& text) {
  if (mentions(text, "top") && mentions(text, "left")) return GazeOrigin::TopLeft;
  if (mentions(text, "bottom") && mentions(text, "left")) return GazeOrigin::BottomLeft;
  return GazeOrigin::File;
}

TimeUnit timeUnitNamed(const std::string& text) {
  if (text == "s" || text == "sec" || text.starts_with("second")) return TimeUnit::Seconds;
  if (text == "ms" || text.starts_with("milli")) return TimeUnit::Milliseconds;
  if (text == "us" || text == "\xCE\xBCs" || text == "\xC2\xB5s" || text.starts_with("micro")) {
    return TimeUnit::Microseconds;
  }
  if (text == "ns" || text.starts_with("nano")) return TimeUnit::Nanoseconds;
  return TimeUnit::File;
}

const Json& fieldOf(const Json& json, std::string_view key) {
  static const Json kNone = Json::object();
  if (!json.is_object()) return kNone;
  const auto found = json.find(key);
  return found != json.end() && found->is_object() ? *found : kNone;
}

/// Two numbers, as [1024, 768].
std::optional<glm::dvec2> pairOf(const Json& json, std::string_view key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_array() || found->size() != 2) return std::nullopt;
  const Json& width = (*found)[0];
  const Json& height = (*found)[1];
  if (!width.is_number() || !height.is_number()) return std::nullopt;
  return glm::dvec2(width.get<double>(), height.get<double>());
}

std::optional<Rectangle> resolutionOf(const Json& json) {
  const std::optional<glm::dvec2> size = pairOf(json, "ScreenResolution");
  if (!size || !(size->x >= 1.0 && size->y >= 1.0)) return std::nullopt;
  return Rectangle{{0.0, 0.0}, *size};
}

/// ScreenSize and ScreenDistance, in metres.
void readDisplay(const Json& json, RecordedDisplay& display) {
  constexpr double kMetre = 1000.0;
  if (const auto size = pairOf(json, "ScreenSize"); size && !display.sizeMm()) {
    display.setSize(kMetre * *size);
  }
  const auto distance = json.find("ScreenDistance");
  if (distance != json.end() && distance->is_number() && !display.distanceMm()) {
    display.noteDistance(kMetre * distance->get<double>());
  }
}

class BidsParser final : public TableParser {
 public:
  BidsParser(const Json& json, const Json& stimulus, const LogContext& context)
      : TableParser(headerOf(json), context, '\t'),
        mapper_(coordinates(json, stimulus), options_, where_) {
    if (const auto lack = mapper_.lack()) {
      // The resolution in the JSON is the display's, not a scene camera's.
      mapper_.state(head_.coordinates);
      failInput(
          "{}: {}{}", where_, *lack,
          isOfSceneCamera(head_.coordinates) ? "" : ", or write ScreenResolution into its JSON");
    }
    if (x_ == kAbsent || y_ == kAbsent) (void)require({"x_coordinate"});
    readClock(json);
    pupilIsMillimetres_ = textOf(fieldOf(json, nameOfOr(pupil_)), "Units") == "mm";
    if (const std::string eye = textOf(json, "RecordedEye"); !eye.empty()) {
      head_.notes.push_back("reader: recorded eye: " + oneLine(eye));
    }
    mapper_.state(head_.coordinates);
  }

  Row row(std::string_view text, GazeSample& sample, std::string& problem) override {
    if (!split(text, problem)) return Row::Wrong;
    const std::optional<std::int64_t> time =
        time_ == kAbsent ? std::optional(index_) : this->time(time_, digits_, "a time", problem);
    if (!time) return Row::Wrong;
    for (const Column column : {x_, y_, rightX_, rightY_}) {
      if (column != kAbsent && !isAbsent(column) && !parseNumber(cell(column))) {
        return wrong(column, "a number or n/a", problem);
      }
    }
    sample.timeSeconds = clock_.seconds(*time, head_);
    ++index_;
    const bool blinks = isOne(blink_);
    if (blinks && !blinking_) ++head_.counters.blinks;
    blinking_ = blinks;
    if (rightX_ != kAbsent) {
      combineEyes(eye(x_, y_, leftValidity_), eye(rightX_, rightY_, rightValidity_), std::nullopt,
                  mapper_, head_, sample);
      if (blinks) sample.valid = false;
      return Row::Sample;
    }
    if (const auto place = placeOf(pair(x_, y_), mapper_, head_)) {
      sample.position = *place;
      sample.valid = !blinks;
    }
    if (pupilIsMillimetres_ && sample.valid) {
      if (const auto diameter = pupil(pupil_)) {
        sample.pupilMillimetres = static_cast<float>(*diameter);
      }
    }
    return Row::Sample;
  }

 private:
  [[nodiscard]] std::string_view nameOfOr(Column column) const {
    return column == kAbsent ? std::string_view{} : nameOf(column);
  }

  Coordinates coordinates(const Json& json, const Json& stimulus) const {
    const Json& screen = fieldOf(stimulus, "StimulusPresentation");
    const Json& own = fieldOf(json, "StimulusPresentation");
    Coordinates c;
    c.unitBy = c.originBy = "file";
    c.unit = unitNamed(textOf(fieldOf(json, nameOfOr(x_)), "Units"));
    for (const std::string_view key : {"SampleCoordinateUnits", "SampleCoordinateUnit"}) {
      if (c.unit == GazeUnit::File) c.unit = unitNamed(textOf(json, key));
    }
    for (const Json* const holder : {&screen, &own, &json}) {
      for (const std::string_view key : {"ScreenOrigin", "EnvironmentCoordinates"}) {
        if (c.origin == GazeOrigin::File) c.origin = originNamed(textOf(*holder, key));
      }
      if (!c.screen) c.screen = resolutionOf(*holder);
      readDisplay(*holder, c.display);
    }
    const std::string system = textOf(json, "SampleCoordinateSystem");
    if (mentions(system, "world")) {
      c.of = kSceneCamera;
      c.screen.reset();  // the display's size is not the camera's
      c.display = {};
    }
    if (mentions(system, "eye in head")) {
      failInput("{}: eye-in-head coordinates are no gaze on a screen; give gaze-on-screen", where_);
    }
    head_.display = c.display;
    return c;
  }

  /// A column of times with a unit, otherwise the number of the row and the sampling frequency.
  void readClock(const Json& json) {
    if (time_ != kAbsent) {
      unit_ = timeUnitNamed(textOf(fieldOf(json, nameOf(time_)), "Units"));
      if (options_.timeUnit != TimeUnit::File) unit_ = options_.timeUnit;
      if (unit_ != TimeUnit::File) {
        // One digit more than the unit's own thousandths: clocks of whole milliseconds have .5.
        digits_ = std::min(digitsOf(TimeUnit::Nanoseconds) - digitsOf(unit_), kMostDigits);
        clock_ = TickClock(ticksPerSecond(unit_) * std::pow(10.0, digits_));
        return;
      }
    }
    const auto found = json.find("SamplingFrequency");
    const double hertz = found != json.end() && found->is_number() ? found->get<double>() : 0.0;
    if (!(hertz > 0.0 && hertz < kFastest)) {
      failInput("{}: neither the unit of the timestamps nor SamplingFrequency is said; {}", where_,
                time_ == kAbsent ? "write SamplingFrequency into its JSON"
                                 : "give --gaze.timeUnit s, ms, us or ns");
    }
    if (time_ != kAbsent) {
      head_.notes.emplace_back("reader: timestamps without a unit; times are from the frequency");
    }
    time_ = kAbsent;
    clock_ = TickClock(hertz);
  }

  [[nodiscard]] bool isAbsent(Column column) const {
    const std::string_view text = cell(column);
    return text.empty() || text == "n/a" || text == "." || text == "nan" || text == "NaN";
  }
  [[nodiscard]] bool isOne(Column column) const {
    return cell(column) == "1" || cell(column) == "1.0";
  }

  [[nodiscard]] EyeReading eye(Column x, Column y, Column validity) const {
    EyeReading eye;
    eye.raw = pair(x, y);
    eye.seen = validity == kAbsent ? eye.raw.has_value() : isOne(validity);
    return eye;
  }

  static constexpr int kMostDigits = 9;
  static constexpr double kFastest = 1e6;

  Column x_ = find({"x_coordinate", "eye1_x_coordinate", "left_x_coordinate",
                    "left_gaze_point_on_display_area_x"});
  Column y_ = find({"y_coordinate", "eye1_y_coordinate", "left_y_coordinate",
                    "left_gaze_point_on_display_area_y"});
  Column rightX_ =
      find({"eye2_x_coordinate", "right_x_coordinate", "right_gaze_point_on_display_area_x"});
  Column rightY_ =
      find({"eye2_y_coordinate", "right_y_coordinate", "right_gaze_point_on_display_area_y"});
  Column leftValidity_ = find({"left_gaze_point_validity"});
  Column rightValidity_ = find({"right_gaze_point_validity"});
  Column time_ = find({"timestamp", "eye_timestamp", "device_time_stamp"});
  Column pupil_ = find({"pupil_size", "pupil_diameter"});
  Column blink_ = find({"blink"});
  TimeUnit unit_ = TimeUnit::File;
  int digits_ = 0;
  bool pupilIsMillimetres_ = false;
  bool blinking_ = false;
  std::int64_t index_ = 0;
  CoordinateMapper mapper_;
  TickClock clock_;
};

}  // namespace

bool isBids(std::string_view /*header*/, const LogContext& context) {
  if (context.sidecar.empty()) return false;
  const std::string columns = headerOf(parseJson(context.sidecar));
  const HeaderCells names(columns, '\t');
  return names.has("x_coordinate") || names.hasStart("eye1_x") || names.hasStart("left_");
}

std::unique_ptr<LogParser> openBids(std::string_view /*header*/, const LogContext& context) {
  if (context.sidecar.empty()) {
    failInput(
        "{}: a BIDS recording needs its JSON, as NAME.json beside NAME.tsv; copy it there or give "
        "--gaze.sidecar FILE.json",
        context.where());
  }
  const Json json = parseJson(context.sidecar);
  const std::string header = headerOf(json);
  const HeaderCells names(header, '\t');
  if (!names.has("x_coordinate") && !names.hasStart("eye1_x") && !names.hasStart("left_")) {
    failInput("{}: the JSON beside it lists no 'x_coordinate' in 'Columns'; check it",
              context.where());
  }
  return std::make_unique<BidsParser>(json, parseJson(context.stimulus), context);
}

}  // namespace macula::gaze
