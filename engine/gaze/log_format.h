// The table of log formats: how each is recognised and who parses it.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/gaze/log.h"

namespace macula::gaze {

/// Where in which file; for messages.
struct Place {
  std::string_view file;
  std::size_t line = 0;  ///< from 1
};

/// Understands the rows of one format. Made from the header line; then given every further line
/// that is not blank, in order.
class LogParser {
 public:
  virtual ~LogParser() = default;

  /// Takes one row: adds a sample to the log, counts it, or does neither.
  /// @returns what is wrong with the row and how to mend it, where it cannot be understood; the log
  ///   is unchanged then
  [[nodiscard]] virtual std::optional<std::string> row(std::string_view text, GazeLog& log) = 0;

  /// Called after the last row, for what can be known only then.
  /// @throws InputError where the file as a whole lacks something
  virtual void finish(GazeLog& /*log*/) {}
};

/// One row of the table.
struct LogFormat {
  std::string_view name;     ///< as settings and reports say it
  std::string_view accepts;  ///< what the file looks like, in words
  bool (*recognises)(std::string_view header);
  /// @throws InputError where the header lacks columns
  std::unique_ptr<LogParser> (*open)(std::string_view header, const Place& place);
};

/// Every format, in the order in which they are tried.
[[nodiscard]] std::span<const LogFormat> logFormats();

/// Canonical CSV; see README.md of this folder.
[[nodiscard]] bool isMaculaCsv(std::string_view header);
[[nodiscard]] std::unique_ptr<LogParser> openMaculaCsv(std::string_view header, const Place& place);

/// Tobii Studio text export with one row a sample and event rows in between.
[[nodiscard]] bool isTobiiStudio(std::string_view header);
[[nodiscard]] std::unique_ptr<LogParser> openTobiiStudio(std::string_view header,
                                                         const Place& place);

}  // namespace macula::gaze
