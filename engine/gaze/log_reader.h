// A gaze log one sample at a time, in memory that does not grow with the file.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gaze/log.h"
#include "engine/gaze/log_options.h"

namespace macula::gaze {

/// Reads a log of any known format, as text, UTF-16 or gzip. Files that tell only as a whole where
/// their pixels lie (Tobii Studio) are read twice. Nothing is kept of a sample that was given.
class GazeLogReader {
 public:
  /// Opens a file and reads up to its first rows. BIDS recordings bring a JSON beside them.
  /// @throws InputError as readGazeLog() does; later errors come from next()
  explicit GazeLogReader(const std::filesystem::path& path, const LogOptions& options = {});

  /// The same from a stream, which must outlive the reader and be seekable where a format is read
  /// twice.
  /// @param name stands in messages in place of a path
  /// @param sidecar text of the JSON that describes the columns of a BIDS recording
  GazeLogReader(std::istream& in, std::string_view name, const LogOptions& options = {},
                std::string sidecar = {});
  ~GazeLogReader();
  GazeLogReader(const GazeLogReader&) = delete;
  GazeLogReader& operator=(const GazeLogReader&) = delete;

  /// Takes the next sample, in the order of the file.
  /// @returns false at the end
  /// @throws InputError naming file, line and fix where a row cannot be understood and is not the
  ///   last, or the file ends without one sample
  [[nodiscard]] bool next(GazeSample& sample);

  /// What is known of the log so far; complete once next() has returned false.
  [[nodiscard]] const GazeLogHead& head() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// The files beside a log that are read with it: those of a BIDS recording that are there.
[[nodiscard]] std::vector<std::filesystem::path> sidecarFiles(const std::filesystem::path& path,
                                                              const LogOptions& options);

}  // namespace macula::gaze
