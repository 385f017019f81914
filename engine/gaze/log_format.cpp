#include "engine/gaze/log_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/core/error.h"
#include "engine/core/nearest.h"
#include "engine/gaze/cells.h"
#include "engine/gaze/foreign_file.h"
#include "engine/gaze/formats/formats.h"

namespace macula::gaze {
namespace {

constexpr std::array<LogFormat, 10> kFormats{{
    {"macula-csv", "time_s,x,y,valid", isMaculaCsv, openMaculaCsv},
    {"tobii-studio", "GazePointX and ValidityLeft", isTobiiStudio, openTobiiStudio},
    {"tobii-pro-lab", "Recording timestamp and Gaze point X", isTobiiProLab, openTobiiProLab},
    {"tobii-sdk", "left_gaze_point_on_display_area", isTobiiSdk, openTobiiSdk},
    {"pupil-core", "gaze_timestamp and norm_pos_x", isPupilCore, openPupilCore},
    {"pupil-neon", "timestamp [ns] and gaze x [px]", isPupilNeon, openPupilNeon},
    {"eyelink", "** CONVERTED FROM, MSG or START", isEyeLink, openEyeLink, true},
    {"gazepoint", "TIME(...) and BPOGX or FPOGX", isGazepoint, openGazepoint},
    {"gazebase", "n,x,y,val,dP,lab,xT,yT", isGazeBase, openGazeBase},
    {"bids", "numbers, with a JSON beside it", isBids, openBids, true},
}};

/// Whether a line looks like a row of a table that has no header.
bool isNumbers(std::string_view line) {
  std::vector<std::string_view> words;
  splitWords(line, words);
  for (const std::string_view word : words) {
    if (!parseNumber(word) && word != "n/a") return false;
  }
  return words.size() > 1;
}

}  // namespace

std::string LogContext::where() const {
  return fmt::format("{}: line {}", head.name, line);
}

std::span<const LogFormat> logFormats() {
  return kFormats;
}

std::vector<std::string> gazeFormatNames() {
  std::vector<std::string> names;
  for (const LogFormat& format : kFormats) names.emplace_back(format.name);
  return names;
}

const LogFormat& formatFor(std::string_view header, const LogContext& context) {
  const std::string& wanted = context.options.format;
  const auto named = std::find_if(kFormats.begin(), kFormats.end(),
                                  [&](const LogFormat& format) { return format.name == wanted; });
  if (named == kFormats.end() && wanted != "auto") {
    failInput("gaze format '{}' is unknown; the nearest is '{}'", oneLine(wanted),
              nearestName(wanted, gazeFormatNames()));
  }
  if (const auto foreign = foreignTable(header)) {
    failInput("{}: {}", context.where(), *foreign);
  }
  const auto recognises = [&](const LogFormat& format) {
    return format.recognises(header, context);
  };
  // A header that no format knows may still be read by the format that a person names.
  if (named != kFormats.end() && recognises(*named)) return *named;
  const auto shown = std::find_if(kFormats.begin(), kFormats.end(), recognises);
  if (named != kFormats.end() && shown == kFormats.end()) return *named;
  if (named != kFormats.end()) {
    failInput("{}: gaze.format says {}, but the file is {}; leave it out, or give {}",
              context.where(), named->name, shown->name, shown->name);
  }
  if (shown != kFormats.end()) return *shown;
  std::string known;
  for (const LogFormat& format : kFormats) {
    known += fmt::format("{}{} ({})", known.empty() ? "" : ", ", format.name, format.shows);
  }
  if (isNumbers(header)) {
    failInput(
        "{}: numbers without a header; a BIDS recording needs its JSON, as NAME.json beside "
        "NAME.tsv, "
        "or give --gaze.sidecar FILE.json",
        context.where());
  }
  failInput("{}: not the first line of a gaze log; give one of {}", context.where(), known);
}

int digitsOf(TimeUnit unit) {
  switch (unit) {
    case TimeUnit::Milliseconds:
      return 3;
    case TimeUnit::Microseconds:
      return 6;
    case TimeUnit::Nanoseconds:
      return 9;
    default:
      return 0;
  }
}

double ticksPerSecond(TimeUnit unit) {
  switch (unit) {
    case TimeUnit::Milliseconds:
      return 1e3;
    case TimeUnit::Microseconds:
      return 1e6;
    case TimeUnit::Nanoseconds:
      return 1e9;
    default:
      return 1.0;
  }
}

}  // namespace macula::gaze
