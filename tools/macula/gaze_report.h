// What reports say of the gaze log that a run followed.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/gaze/gaze_settings.h"
#include "engine/gaze/source.h"

namespace macula::tools {

/// {"width_mm", "height_mm", "distance_mm", "size_by", "distance_by"}; by "setting", "file" or
/// "assumed".
[[nodiscard]] nlohmann::ordered_json toJson(const gaze::KnownDisplay& known);

/// The gaze of a replay or of `hold`. Points and the mouse are no log and say nothing of this.
class FollowedGaze {
 public:
  /// @param source must outlive this
  FollowedGaze(const gaze::GazeSource& source, const gaze::GazeSettings& settings);

  /// Lines for a person, each with the log's name.
  [[nodiscard]] std::vector<std::string> warnings() const;
  /// Writes the warnings to standard error.
  void printWarnings() const;
  /// Writes one line to standard error where the log is over before the last frame.
  /// @param fps frame i is at i / fps
  void printEnd(double fps, int frames) const;

  /// Whether errors in degrees mean something.
  [[nodiscard]] bool hasDegrees() const;
  [[nodiscard]] const gaze::Display& display() const;
  /// What `gaze_error_deg` is: from what to what on which display, or why it is 0 or null.
  [[nodiscard]] std::string errorBasis() const;
  /// `gaze_log` of a report; null where there is none.
  [[nodiscard]] nlohmann::ordered_json toJson() const;

 private:
  const gaze::ReplayGaze* log_;
  const gaze::GazeSettings& settings_;
};

}  // namespace macula::tools
