// A recorded gaze log as plain data, whatever the file was.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gaze/display.h"
#include "engine/gaze/log_options.h"

namespace macula::gaze {

/// A position that was not measured.
inline constexpr glm::dvec2 kNoPosition{std::numeric_limits<double>::quiet_NaN()};

/// One reading of the tracker.
struct GazeSample {
  double timeSeconds = 0.0;  ///< since the log's first sample; by the tracker's clock
  /// 0..1 of the window from the top left; outside that where the gaze left the window; NaN where
  /// the file holds no place.
  glm::dvec2 position = kNoPosition;
  bool valid = false;                     ///< what the tracker says: at least one eye was seen
  std::optional<float> confidence;        ///< 0..1
  std::optional<float> pupilMillimetres;  ///< diameter, mean of the eyes that were seen
};

/// What the coordinates of the file were before they became 0..1, and who said so: "file" (a column
/// or a message in it), "format" (its maker's definition) or "setting".
struct CoordinateStatement {
  std::string unit;    ///< "0..1", "px" or "deg"
  std::string origin;  ///< "top left", "bottom left", "centre" or "centre, y up"
  std::optional<glm::dvec2>
      screenPixels;           ///< the size that pixels were divided by, where one holds
  std::string of = "screen";  ///< or "window", "scene camera", "surface", "medium"
  std::string unitBy = "format";
  std::string originBy = "format";
  std::string screenBy = "file";  ///< of screenPixels
  std::string mapping = {};       ///< how degrees became places; empty for the others
};

/// CoordinateStatement::of a camera on the viewer's head.
inline constexpr std::string_view kSceneCamera = "scene camera";

/// The places are of the picture of a camera on the viewer's head, not of a display.
[[nodiscard]] bool isOfSceneCamera(const CoordinateStatement& coordinates);

/// The statement in one line: "px (file) from the top left (format) of the screen, 1280x1024
/// (file)".
[[nodiscard]] std::string describe(const CoordinateStatement& coordinates);

/// Times further apart than this are a gap: the recording was paused or cut.
inline constexpr double kGapSeconds = 1.0;

/// No recording is longer: 300 years. Beyond it a time is a slip, and what is written would not be
/// read again.
inline constexpr double kLongestLogSeconds = 1e10;

/// Rows that are no ordinary samples, and times that cannot be integrated over.
struct GazeCounters {
  std::size_t eventRows = 0;       ///< rows that carry a mark instead of gaze
  std::size_t truncatedRows = 0;   ///< 1 where the last row was cut off; it is not a sample
  std::size_t duplicateTimes = 0;  ///< samples at the newest time so far: kept here, not replayed
  std::size_t backwardTimes = 0;   ///< samples before it: kept here, not replayed
  std::size_t gaps = 0;            ///< steps forward of more than kGapSeconds
  std::size_t sentinels = 0;       ///< places called valid that stand for none: (0,0), -1280, codes
  std::size_t twoEyeSamples = 0;   ///< samples that tell of each eye: the next three are of those
  std::size_t leftLost = 0;        ///< samples without the left eye
  std::size_t rightLost = 0;       ///< samples without the right eye
  std::size_t bothLost = 0;        ///< samples without either
  std::size_t blinks = 0;          ///< blinks that the file marks, of each eye
  std::size_t saccades = 0;        ///< saccades that the file marks, of each eye
  std::size_t blocks = 0;          ///< recordings in one file, where it marks them
  std::size_t clockRestarts = 0;   ///< times that the file's clock began again and was continued
};

/// A gaze log without its samples. While a log is being read, what is known so far.
struct GazeLogHead {
  std::string name;           ///< path, or what the caller named it
  std::string format;         ///< a name of gazeFormatNames()
  double startSeconds = 0.0;  ///< time of the first sample as the file gives it
  CoordinateStatement coordinates;
  RecordedDisplay display;
  GazeCounters counters;
  std::vector<std::string> notes;  ///< comments of the file without '#', and of its reader
};

/// A gaze log in the order of the file.
struct GazeLog : GazeLogHead {
  std::vector<GazeSample> samples;
};

/// The names of the formats that can be read, for settings and messages.
[[nodiscard]] std::vector<std::string> gazeFormatNames();

/// Reads a whole gaze log, line by line and without regard to the locale; see log_reader.h for logs
/// that are larger than the memory.
/// @throws InputError naming file, line and fix where the file cannot be read, is no gaze log,
///   holds no sample, or holds a row that cannot be understood. A last row that was cut off is
///   counted instead.
[[nodiscard]] GazeLog readGazeLog(const std::filesystem::path& path,
                                  const LogOptions& options = {});

/// The same from an open stream.
/// @param name stands in messages in place of a path
[[nodiscard]] GazeLog readGazeLog(std::istream& in, std::string_view name,
                                  const LogOptions& options = {});

/// The log as canonical CSV (see README.md of this folder). Numbers are written in the shortest
/// form that reads back to the same bits; a position that is not finite makes the sample invalid.
[[nodiscard]] std::string canonicalCsv(const GazeLog& log);

}  // namespace macula::gaze
