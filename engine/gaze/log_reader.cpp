#include "engine/gaze/log_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <istream>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/gaze/byte_source.h"
#include "engine/gaze/cells.h"
#include "engine/gaze/foreign_file.h"
#include "engine/gaze/line_reader.h"
#include "engine/gaze/log_format.h"

namespace macula::gaze {
namespace {

constexpr std::string_view kCanonicalFormat = "macula-csv";
constexpr double kSecondsPerYear = 3.156e7;

// Comments are kept so that "synthetic" survives a conversion; more than these are dropped, so that
// a file of comments fills no memory.
constexpr std::size_t kMostNotes = 64;
// A sidecar describes columns; the largest known have a few kilobytes.
constexpr std::uintmax_t kLargestSidecar = 1'000'000;

std::unique_ptr<std::istream> openFile(const std::filesystem::path& path) {
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
  auto in = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*in) {
    failInput("{}: cannot be read ({}); check its permissions", path.string(),
              std::strerror(errno));
  }
  return in;
}

/// The text of a JSON file; empty where there is none.
std::string readSidecar(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  if (std::filesystem::file_size(path, error) > kLargestSidecar) {
    failInput("{}: larger than a description of columns; check the file", path.string());
  }
  return readTextFile(path);
}

std::optional<std::string> withoutEnd(std::string_view text, std::string_view end) {
  if (!text.ends_with(end)) return std::nullopt;
  return std::string(text.substr(0, text.size() - end.size()));
}

/// What stands beside a BIDS recording: a_recording-eye1_physio.json describes the columns of
/// a_recording-eye1_physio.tsv.gz, a_events.json the screen.
struct Sidecars {
  std::string columns;
  std::string stimulus;
};

/// Where they would lie; empty where there is none for a log of this name.
struct SidecarPaths {
  std::string columns;
  std::string stimulus;
};

SidecarPaths sidecarPaths(const std::filesystem::path& path, const LogOptions& options) {
  const std::string file = path.string();
  std::optional<std::string> stem = withoutEnd(file, ".tsv.gz");
  if (!stem) stem = withoutEnd(file, ".tsv");
  SidecarPaths paths;
  if (!options.sidecar.empty()) {
    paths.columns = options.sidecar;
  } else if (stem) {
    paths.columns = *stem + ".json";
  }
  const std::optional<std::string> run = stem ? withoutEnd(*stem, "_physio") : std::nullopt;
  if (run) {
    const std::size_t recording = run->rfind("_recording-");
    const bool inName =
        recording != std::string::npos && run->find_first_of("/\\", recording) == std::string::npos;
    paths.stimulus = (inName ? run->substr(0, recording) : *run) + "_events.json";
  }
  return paths;
}

Sidecars sidecarsOf(const std::filesystem::path& path, const LogOptions& options) {
  if (!options.sidecar.empty() && !std::filesystem::is_regular_file(options.sidecar)) {
    failInput("gaze.sidecar '{}': no such file; check the path", oneLine(options.sidecar));
  }
  const SidecarPaths paths = sidecarPaths(path, options);
  Sidecars sidecars;
  if (!paths.columns.empty()) sidecars.columns = readSidecar(paths.columns);
  if (!paths.stimulus.empty()) sidecars.stimulus = readSidecar(paths.stimulus);
  return sidecars;
}

}  // namespace

std::vector<std::filesystem::path> sidecarFiles(const std::filesystem::path& path,
                                                const LogOptions& options) {
  const SidecarPaths paths = sidecarPaths(path, options);
  std::vector<std::filesystem::path> files;
  for (const std::string& file : {paths.columns, paths.stimulus}) {
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error)) files.emplace_back(file);
  }
  return files;
}

class GazeLogReader::Impl {
 public:
  Impl(std::unique_ptr<std::istream> file, std::istream& in, std::string_view name,
       LogOptions options, Sidecars sidecars)
      : options_(std::move(options)),
        sidecars_(std::move(sidecars)),
        file_(std::move(file)),
        text_(openText(in, name)),
        lines_(*text_, name) {
    head_.name = name;
    open();
  }

  bool next(GazeSample& sample) {
    std::string_view line;
    while (nextRow(line)) {
      if (problem_) failInput("{}: line {}: {}", head_.name, problemLine_, *problem_);
      sample = GazeSample{};
      std::string problem;
      const Row row = parser_->row(line, sample, problem);
      if (row == Row::Sample && std::abs(sample.timeSeconds) > kLongestLogSeconds) {
        problem_ = fmt::format("its time lies {:.0f} years from the first sample; correct it",
                               sample.timeSeconds / kSecondsPerYear);
        problemLine_ = lines_.number();
        continue;
      }
      if (row == Row::Sample) {
        countTime(sample.timeSeconds);
        ++samples_;
        return true;
      }
      if (row == Row::Wrong) {
        // Whether this is the last row, cut off, or a mistake in the middle shows only afterwards.
        problem_ = std::move(problem);
        problemLine_ = lines_.number();
      }
    }
    end();
    return false;
  }

  [[nodiscard]] const GazeLogHead& head() const { return head_; }

 private:
  void open() {
    std::string_view header;
    if (!nextRow(header)) {
      failInput("{}: line 1: the file is empty; give a gaze log", head_.name);
    }
    // What looked like UTF-16 may still be binary data.
    if (const auto foreign = foreignBytes(header.substr(0, kForeignBytes))) {
      failInput("{}: {}", head_.name, *foreign);
    }
    const LogContext context{head_, options_, lines_.number(), sidecars_.columns,
                             sidecars_.stimulus};
    const LogFormat& format = formatFor(header, context);
    head_.format = format.name;
    const auto comments = static_cast<std::ptrdiff_t>(head_.notes.size());
    parser_ = format.open(header, context);
    const std::vector<std::string> remarks(head_.notes.begin() + comments, head_.notes.end());
    if (!format.headerIsRow && !parser_->wantsSurvey()) return;

    if (parser_->wantsSurvey()) {
      std::string_view line;
      while (nextRow(line)) parser_->survey(line);
    }
    head_.notes = remarks;  // the comments are met again
    lines_.rewind();
    if (!format.headerIsRow) (void)nextRow(header);
  }

  /// The next line that is neither blank nor a comment.
  bool nextRow(std::string_view& line) {
    while (lines_.next(line)) {
      // Behind the header of another format, '#' is what a cell begins with.
      if (line.starts_with('#') && (parser_ == nullptr || head_.format == kCanonicalFormat)) {
        keepNote(line);
      } else if (!trimmed(line).empty()) {
        return true;
      }
    }
    return false;
  }

  void keepNote(std::string_view comment) {
    comment.remove_prefix(1);
    if (head_.notes.size() >= kMostNotes) return;
    head_.notes.emplace_back(trimmed(repairedUtf8(oneLine(comment))));
  }

  void countTime(double time) {
    if (samples_ == 0) {
      newest_ = time;
      return;
    }
    if (time == newest_) ++head_.counters.duplicateTimes;
    if (time < newest_) ++head_.counters.backwardTimes;
    if (time > newest_ + kGapSeconds) ++head_.counters.gaps;
    newest_ = std::max(newest_, time);
  }

  void end() {
    if (ended_) return;
    ended_ = true;
    if (samples_ == 0) {
      if (problem_) failInput("{}: line {}: {}", head_.name, problemLine_, *problem_);
      failInput("{}: line {}: no gaze sample follows the header; record or export again{}",
                head_.name, lines_.number(),
                options_.format == "auto"
                    ? ""
                    : fmt::format(", or leave out gaze.format where it is not {}", head_.format));
    }
    if (problem_) ++head_.counters.truncatedRows;
  }

  LogOptions options_;
  Sidecars sidecars_;
  std::unique_ptr<std::istream> file_;
  std::unique_ptr<ByteSource> text_;
  LineReader lines_;
  GazeLogHead head_;
  std::unique_ptr<LogParser> parser_;
  std::optional<std::string> problem_;
  std::size_t problemLine_ = 0;
  std::size_t samples_ = 0;
  double newest_ = 0.0;
  bool ended_ = false;
};

GazeLogReader::GazeLogReader(const std::filesystem::path& path, const LogOptions& options) {
  std::unique_ptr<std::istream> file = openFile(path);
  std::istream& in = *file;
  impl_ = std::make_unique<Impl>(std::move(file), in, path.string(), options,
                                 sidecarsOf(path, options));
}

GazeLogReader::GazeLogReader(std::istream& in, std::string_view name, const LogOptions& options,
                             std::string sidecar)
    : impl_(std::make_unique<Impl>(nullptr, in, name, options, Sidecars{std::move(sidecar), {}})) {}

GazeLogReader::~GazeLogReader() = default;

bool GazeLogReader::next(GazeSample& sample) {
  return impl_->next(sample);
}

const GazeLogHead& GazeLogReader::head() const {
  return impl_->head();
}

}  // namespace macula::gaze
