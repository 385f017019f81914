// points.jsonl: finished points, one a line, so that an interrupted experiment goes on where it
// was.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "engine/experiment/point.h"

namespace macula::experiment {

class PointsFile {
 public:
  /// Reads what is there. A line that an interruption cut off is left out, and the file is written
  /// again without it, so that the next line begins on its own.
  /// @throws InputError where the file cannot be read or written
  explicit PointsFile(std::filesystem::path path);

  /// The point with this key, or null.
  [[nodiscard]] const Point* find(const std::string& key) const;
  /// Writes the lines at once and waits until the disk has them.
  /// @throws InputError where they cannot be written
  void append(std::span<const Point> points);
  [[nodiscard]] std::size_t damagedLines() const { return damaged_; }

 private:
  std::filesystem::path path_;
  std::map<std::string, Point> points_;
  std::size_t damaged_ = 0;
};

}  // namespace macula::experiment
