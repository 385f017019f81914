// The table of log formats: how each is recognised and who parses it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/gaze/log.h"
#include "engine/gaze/log_options.h"

namespace macula::gaze {

/// What a parser is made from and what it fills in.
struct LogContext {
  GazeLogHead& head;              ///< name is set; coordinates, counters and notes are the parser's
  const LogOptions& options;      ///< outlives the parser, as head does
  std::size_t line = 0;           ///< of the header, from 1
  std::string_view sidecar = {};  ///< JSON that describes the columns; empty where there is none
  std::string_view stimulus = {};  ///< JSON that describes the screen; empty where there is none

  /// "file: line 3", as messages begin.
  [[nodiscard]] std::string where() const;
};

/// What a row was.
enum class Row {
  Sample,  ///< a sample was filled in
  Other,   ///< nothing, or something that was counted
  Wrong,   ///< it cannot be understood
};

/// Understands the rows of one format. Made from the header line; then given every line after it
/// that is neither blank nor a comment, in order.
class LogParser {
 public:
  virtual ~LogParser() = default;

  /// Whether survey() must see all rows before the first row().
  [[nodiscard]] virtual bool wantsSurvey() const { return false; }
  /// Looks at one row for what only the whole file tells. Rows that are wrong are passed over.
  virtual void survey(std::string_view /*text*/) {}

  /// Takes one row.
  /// @param sample is filled in where the row is one; it comes in its default state
  /// @param problem is set where the row is wrong: what is wrong and how to fix it
  [[nodiscard]] virtual Row row(std::string_view text, GazeSample& sample,
                                std::string& problem) = 0;
};

/// One row of the table.
struct LogFormat {
  std::string_view name;   ///< as settings and reports say it
  std::string_view shows;  ///< by what in its first line it is known, in words
  /// @param header the first line that is neither blank nor a comment
  bool (*recognises)(std::string_view header, const LogContext& context);
  /// @throws InputError where the header lacks columns
  std::unique_ptr<LogParser> (*open)(std::string_view header, const LogContext& context);
  bool headerIsRow = false;  ///< the first line is given to row() too
};

/// Every format, in the order in which they are tried.
[[nodiscard]] std::span<const LogFormat> logFormats();

/// The format that the options name, or that the header shows.
/// @throws InputError where it is none
[[nodiscard]] const LogFormat& formatFor(std::string_view header, const LogContext& context);

/// Times of samples from a clock that counts: exact, since differences are taken of integers.
class TickClock {
 public:
  explicit TickClock(double ticksPerSecond = 1.0) : ticksPerSecond_(ticksPerSecond) {}
  /// Seconds since the first tick that was asked for; that one becomes the log's start.
  /// @param ticks within kLargestTicks of zero
  [[nodiscard]] double seconds(std::int64_t ticks, GazeLogHead& head) {
    if (!first_) {
      first_ = ticks;
      head.startSeconds = static_cast<double>(ticks) / ticksPerSecond_;
    }
    return static_cast<double>(ticks - *first_) / ticksPerSecond_;
  }

 private:
  double ticksPerSecond_;
  std::optional<std::int64_t> first_;
};

/// How many decimal digits a unit lies below the second: 3 for milliseconds. @param unit not File
[[nodiscard]] int digitsOf(TimeUnit unit);
/// The inverse of the length of a unit in seconds. @param unit not File
[[nodiscard]] double ticksPerSecond(TimeUnit unit);

}  // namespace macula::gaze
