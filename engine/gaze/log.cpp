#include "engine/gaze/log.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <istream>
#include <system_error>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/nearest.h"
#include "engine/gaze/cells.h"
#include "engine/gaze/line_reader.h"
#include "engine/gaze/log_format.h"

namespace macula::gaze {
namespace {

// Comments are kept so that "synthetic" survives a conversion; more than these are dropped, so that
// a file of comments fills no memory.
constexpr std::size_t kMostNotes = 64;

const LogFormat& formatNamed(const std::string& name) {
  for (const LogFormat& format : logFormats()) {
    if (format.name == name) return format;
  }
  const std::vector<std::string> names = gazeFormatNames();
  failInput("gaze format '{}' is unknown; the nearest is '{}'", name, nearestName(name, names));
}

const LogFormat& formatOf(std::string_view header, const Place& place) {
  std::string accepted;
  for (const LogFormat& format : logFormats()) {
    if (format.recognises(header)) return format;
    accepted += (accepted.empty() ? "" : "; or ") + std::string(format.accepts);
  }
  failInput("{}: line {}: not the header of a gaze log; give a {}", place.file, place.line,
            accepted);
}

void keepNote(std::string_view comment, GazeLog& log) {
  comment.remove_prefix(1);
  if (log.notes.size() < kMostNotes) log.notes.emplace_back(trimmed(oneLine(comment)));
}

/// Times count from the first sample; those that do not go forward are counted.
void countTimes(GazeLog& log) {
  double newest = log.samples.front().timeSeconds;
  for (std::size_t i = 1; i < log.samples.size(); ++i) {
    const double time = log.samples[i].timeSeconds;
    if (time == newest) ++log.counters.duplicateTimes;
    if (time < newest) ++log.counters.backwardTimes;
    newest = std::max(newest, time);
  }
}

void readRows(LineReader& lines, LogParser& parser, GazeLog& log) {
  // Whether a bad row is the last one, cut off, or a mistake in the middle shows only afterwards.
  std::optional<std::string> problem;
  std::size_t problemLine = 0;
  std::string_view line;
  while (lines.next(line)) {
    if (trimmed(line).empty()) continue;
    if (line.starts_with('#')) {
      keepNote(line, log);
      continue;
    }
    if (problem) failInput("{}: line {}: {}", log.name, problemLine, *problem);
    problem = parser.row(line, log);
    problemLine = lines.number();
  }
  if (!problem) return;
  if (log.samples.empty()) failInput("{}: line {}: {}", log.name, problemLine, *problem);
  ++log.counters.truncatedRows;
}

}  // namespace

GazeLog readGazeLog(std::istream& in, std::string_view name,
                    const std::optional<std::string>& format) {
  GazeLog log;
  log.name = name;
  const LogFormat* chosen = format ? &formatNamed(*format) : nullptr;

  LineReader lines(in, name);
  std::string_view header;
  bool found = false;
  while (!found && lines.next(header)) {
    if (header.starts_with('#')) {
      keepNote(header, log);
    } else {
      found = !trimmed(header).empty();
    }
  }
  if (!found) failInput("{}: line 1: the file is empty; give a gaze log", name);
  const Place place{log.name, lines.number()};
  if (chosen == nullptr) chosen = &formatOf(header, place);
  log.format = chosen->name;

  const std::unique_ptr<LogParser> parser = chosen->open(header, place);
  readRows(lines, *parser, log);
  if (log.samples.empty()) {
    failInput("{}: line {}: no gaze sample follows the header; record or export again", name,
              lines.number());
  }
  parser->finish(log);
  countTimes(log);
  return log;
}

GazeLog readGazeLog(const std::filesystem::path& path, const std::optional<std::string>& format) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    failInput("{}: no such gaze log; check the path", path.string());
  }
  if (std::filesystem::is_directory(status)) {
    failInput("{}: is a folder; name a gaze log in it", path.string());
  }
  // A device or a pipe may never end.
  if (!std::filesystem::is_regular_file(status)) {
    failInput("{}: is not a regular file; save the gaze log to one", path.string());
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    failInput("{}: cannot be read ({}); check its permissions", path.string(),
              std::strerror(errno));
  }
  return readGazeLog(in, path.string(), format);
}

}  // namespace macula::gaze
