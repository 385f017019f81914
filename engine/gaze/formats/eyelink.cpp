// EyeLink ASC (SR Research edf2asc): blocks of samples from START to END, with events, messages and
// calibrations in between; one eye or both, with a head target in remote mode.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "engine/core/error.h"
#include "engine/gaze/formats/formats.h"
#include "engine/gaze/formats/table_parser.h"

namespace macula::gaze {
namespace {

constexpr int kMilliToMicro = 3;
// Two samples share each millisecond at 2 kHz, where the converter writes whole ones.
constexpr double kHalvedRate = 2000.0;
constexpr std::int64_t kHalfMillisecond = 500;

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Corners as messages give them. The last is that of the last pixel (1919), so the width is one
/// more; some scripts send the width itself (1920). Screens have even sides: an odd corner is a
/// pixel's, an even one a size.
double sideOf(double first, double last) {
  const double side = last - first;
  return std::fmod(side, 2.0) == 0.0 ? side : side + 1.0;
}

class EyeLinkParser final : public LogParser {
 public:
  explicit EyeLinkParser(const LogContext& context)
      : head_(context.head),
        mapper_({.unit = GazeUnit::Pixels, .origin = GazeOrigin::TopLeft}, context.options,
                context.where()) {
    mapper_.state(head_.coordinates);
  }

  Row row(std::string_view text, GazeSample& sample, std::string& problem) override {
    if (isDigit(text.front())) return sampleRow(text, sample, problem);
    if (text.starts_with("**") || !(text.front() >= 'A' && text.front() <= 'Z')) {
      return Row::Other;  // preamble; tables and formulas of the calibration
    }
    splitWords(text, words_);
    const std::string_view key = words_[0];
    if (key == "MSG" || key == "INPUT" || key == "BUTTON") {
      ++head_.counters.eventRows;
      if (key == "MSG") message();
    } else if (key == "START") {
      ++head_.counters.blocks;
      setEyes();
    } else if (key == "SAMPLES") {
      return samplesLine(problem);
    } else if (isEvent(key)) {
      ++head_.counters.eventRows;
      if (key == "EBLINK") ++head_.counters.blinks;
      if (key == "ESACC") ++head_.counters.saccades;
    }
    return Row::Other;
  }

 private:
  static bool isEvent(std::string_view key) {
    constexpr std::array<std::string_view, 6> kEvents{"SFIX",  "EFIX",   "SSACC",
                                                      "ESACC", "SBLINK", "EBLINK"};
    for (const std::string_view event : kEvents) {
      if (key == event) return true;
    }
    return false;
  }

  /// "MSG 642433 GAZE_COORDS 0.00 0.00 1919.00 1079.00", also with '=' after the name.
  void message() {
    if (words_.size() < 3) return;
    displayMessage();
    const bool gaze = words_[2] == "GAZE_COORDS";
    if (!gaze && words_[2] != "DISPLAY_COORDS") return;
    if (!gaze && gazeCoords_) return;  // those of the tracker hold over those of the script
    std::array<double, 4> corners{};
    const std::size_t found = numbersOfMessage(corners);
    const glm::dvec2 size{sideOf(corners[0], corners[2]), sideOf(corners[1], corners[3])};
    if (found < corners.size() || !(size.x >= 1.0 && size.y >= 1.0)) return;
    gazeCoords_ = gazeCoords_ || gaze;
    mapper_.setScreen({{corners[0], corners[1]}, size});
    mapper_.state(head_.coordinates);
  }

  /// The numbers behind a message's name; '=' and other words are passed over.
  std::size_t numbersOfMessage(std::array<double, 4>& numbers) const {
    std::size_t found = 0;
    for (std::size_t i = 3; i < words_.size() && found < numbers.size(); ++i) {
      if (const auto number = parseNumber(words_[i])) numbers[found++] = *number;
    }
    return found;
  }

  /// What scripts send of the tracker's physical.ini, in millimetres: "screen_phys_coords = -188,
  /// 145, 188, -145" from the middle, "screen_distance = 600 660" to its upper and lower edge.
  void displayMessage() {
    std::array<double, 4> numbers{};
    if (words_[2] == "SCREEN_PHYS_COORDS" || words_[2] == "screen_phys_coords") {
      if (numbersOfMessage(numbers) < 4) return;
      head_.display.setSize({std::abs(numbers[2] - numbers[0]), std::abs(numbers[3] - numbers[1])});
    } else if (words_[2] == "SCREEN_DISTANCE" || words_[2] == "screen_distance") {
      const std::size_t found = numbersOfMessage(numbers);
      if (found > 0)
        head_.display.noteDistance(found > 1 ? 0.5 * (numbers[0] + numbers[1]) : numbers[0]);
    }
  }

  void setEyes() {
    left_ = right_ = false;
    for (const std::string_view word : words_) {
      left_ = left_ || word == "LEFT";
      right_ = right_ || word == "RIGHT";
    }
  }

  /// "SAMPLES GAZE LEFT RIGHT RATE 1000.00 TRACKING CR FILTER 2".
  Row samplesLine(std::string& problem) {
    if (words_.size() > 1 && words_[1] != "GAZE") {
      problem = fmt::format("samples are {} instead of GAZE; convert the EDF with gaze samples",
                            oneLine(words_[1]));
      return Row::Wrong;
    }
    setEyes();
    halved_ = false;
    for (std::size_t i = 0; i + 1 < words_.size(); ++i) {
      if (words_[i] == "RATE") halved_ = parseNumber(words_[i + 1]) == kHalvedRate;
    }
    return Row::Other;
  }

  /// "1408660 964.3 541.5 288.0 960.5 538.8 305.0 .....": time, then x, y and pupil of each eye.
  Row sampleRow(std::string_view text, GazeSample& sample, std::string& problem) {
    if (!left_ && !right_) {
      problem = "a sample before START and SAMPLES say which eyes; convert the EDF with them";
      return Row::Wrong;
    }
    if (const auto lack = mapper_.lack()) {
      problem = *lack + "; no GAZE_COORDS or DISPLAY_COORDS stands before it";
      return Row::Wrong;
    }
    const bool both = left_ && right_;
    const std::size_t count = both ? 7 : 4;
    if (const std::size_t got = firstWords(text, count); got < count) {
      problem = fmt::format("{} instead of {} of {}; convert the EDF again", counted(got, "number"),
                            count, both ? "both eyes" : "one eye");
      return Row::Wrong;
    }
    std::optional<std::int64_t> time = parseTicks(numbers_[0], kMilliToMicro);
    if (!time) {
      problem = fmt::format("the time is '{}' instead of milliseconds; convert the EDF again",
                            oneLine(numbers_[0]));
      return Row::Wrong;
    }
    const bool second = halved_ && time == lastTime_;
    lastTime_ = second ? std::nullopt : time;
    if (second) *time += kHalfMillisecond;
    EyeReading eyes[2];
    for (std::size_t eye = 0; eye < (both ? 2 : 1); ++eye) {
      if (!readEye(1 + 3 * eye, eyes[eye], problem)) return Row::Wrong;
    }
    sample.timeSeconds = clock_.seconds(*time, head_);
    if (both) {
      combineEyes(eyes[0], eyes[1], std::nullopt, mapper_, head_, sample);
    } else if (eyes[0].seen) {
      if (const auto place = placeOf(eyes[0].raw, mapper_, head_)) {
        sample.position = *place;
        sample.valid = true;
      }
    }
    return Row::Sample;
  }

  /// The first words of a row into numbers_; rows have up to 20, of which few are needed.
  std::size_t firstWords(std::string_view text, std::size_t count) {
    const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
    std::size_t i = 0;
    std::size_t found = 0;
    while (found < count) {
      while (i < text.size() && isBlank(text[i])) ++i;
      if (i == text.size()) break;
      const std::size_t begin = i;
      while (i < text.size() && !isBlank(text[i])) ++i;
      numbers_[found++] = text.substr(begin, i - begin);
    }
    return found;
  }

  /// Three words from `first` on; '.' is what was not seen. Pupils are in the tracker's own units.
  bool readEye(std::size_t first, EyeReading& eye, std::string& problem) const {
    glm::dvec2 raw{0.0};
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string_view word = numbers_[first + i];
      if (word == ".") return true;
      const std::optional<double> number = parseNumber(word);
      if (!number) {
        problem = fmt::format("'{}' instead of a coordinate; convert the EDF again", oneLine(word));
        return false;
      }
      raw[static_cast<int>(i)] = *number;
    }
    eye.seen = true;
    eye.raw = raw;
    return true;
  }

  GazeLogHead& head_;
  CoordinateMapper mapper_;
  TickClock clock_{1e6};
  std::vector<std::string_view> words_;
  std::array<std::string_view, 7> numbers_;
  bool left_ = false;
  bool right_ = false;
  bool gazeCoords_ = false;
  bool halved_ = false;
  std::optional<std::int64_t> lastTime_;
};

}  // namespace

bool isEyeLink(std::string_view header, const LogContext& /*context*/) {
  return header.starts_with("** ") || header.starts_with("MSG\t") ||
         header.starts_with("START\t") || header.starts_with("MSG ");
}

std::unique_ptr<LogParser> openEyeLink(std::string_view /*header*/, const LogContext& context) {
  return std::make_unique<EyeLinkParser>(context);
}

}  // namespace macula::gaze
