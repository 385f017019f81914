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

namespace macula::gaze {

/// A position that nobody measured.
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

/// What the file said about its coordinates before they became 0..1.
struct CoordinateStatement {
  std::string unit;    ///< "0..1" or "px"
  std::string origin;  ///< "top left"
  std::optional<glm::dvec2>
      screenPixels;  ///< the size that pixels were divided by, where one holds
};

/// Rows that are no ordinary samples, and times that cannot be integrated over.
struct GazeCounters {
  std::size_t eventRows = 0;       ///< rows that carry a mark instead of gaze
  std::size_t truncatedRows = 0;   ///< 1 where the last row was cut off; it is not a sample
  std::size_t duplicateTimes = 0;  ///< samples at the newest time so far: kept here, not replayed
  std::size_t backwardTimes = 0;   ///< samples before it: kept here, not replayed
};

/// A gaze log in the order of the file.
struct GazeLog {
  std::string name;    ///< path, or what the caller named it
  std::string format;  ///< a name of gazeFormatNames()
  std::vector<GazeSample> samples;
  double startSeconds = 0.0;  ///< time of the first sample as the file gives it
  CoordinateStatement coordinates;
  GazeCounters counters;
  std::vector<std::string> notes;  ///< comments of the file, without '#'
};

/// The names of the formats that can be read, for settings and messages.
[[nodiscard]] std::vector<std::string> gazeFormatNames();

/// Reads a gaze log, line by line and without regard to the locale.
/// @param format a name of gazeFormatNames(); found by content where absent
/// @throws InputError naming file, line and mend where the file cannot be read, is no gaze log,
///   holds no sample, or holds a row that cannot be understood. A last row that was cut off is
///   counted instead.
[[nodiscard]] GazeLog readGazeLog(const std::filesystem::path& path,
                                  const std::optional<std::string>& format = std::nullopt);

/// The same from an open stream.
/// @param name stands in messages in place of a path
[[nodiscard]] GazeLog readGazeLog(std::istream& in, std::string_view name,
                                  const std::optional<std::string>& format = std::nullopt);

/// The log as canonical CSV (see README.md of this folder). Numbers are written in the shortest
/// form that reads back to the same bits; a position that is not finite makes the sample invalid.
[[nodiscard]] std::string canonicalCsv(const GazeLog& log);

}  // namespace macula::gaze
