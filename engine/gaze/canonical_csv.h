// Canonical gaze CSV, written; formats/macula_csv.cpp reads it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/gaze/log.h"

namespace macula::gaze {

/// How the comment begins that says of what format and coordinates a converted log was.
inline constexpr std::string_view kConverted = "converted from ";

/// Which of the optional columns a log needs.
struct CanonicalColumns {
  bool confidence = false;
  bool pupil = false;
  /// Adds what this sample has.
  void note(const GazeSample& sample);
};

/// Comments and header. @param out text is appended
void writeCanonicalHeader(const GazeLogHead& head, const CanonicalColumns& columns,
                          std::string& out);
/// One row. @param out text is appended
void writeCanonicalRow(const GazeSample& sample, const CanonicalColumns& columns, std::string& out);

/// Converts a log of any format and size to canonical CSV, in memory that does not grow with it:
/// the log is read once for the columns and once for the rows. A comment says of what format and
/// coordinates it was. `out` is replaced only when done.
/// @returns what the log was, and how many samples were written
/// @throws InputError where the log cannot be read or `out` cannot be written
struct Conversion {
  GazeLogHead head;
  std::size_t samples = 0;
};
Conversion convertGazeLog(const std::filesystem::path& path, const std::filesystem::path& out,
                          const LogOptions& options = {});

}  // namespace macula::gaze
