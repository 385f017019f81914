// The text of a recording's files.
#pragma once

#include <string>
#include <string_view>

#include "engine/gaze/log.h"
#include "engine/recording/recording.h"

namespace macula::recording {

/// session.json.
[[nodiscard]] std::string sessionText(const Session& session);

/// Appends one line of frames.jsonl, its line end included.
void appendFrameLine(const Frame& frame, std::string& line);

/// The header of gaze_raw.csv: a canonical gaze CSV (engine/gaze/README.md) with every column.
inline constexpr std::string_view kGazeHeader = "time_s,x,y,valid,confidence,pupil_mm\n";

/// Appends one row of gaze_raw.csv, its line end included. A place that is not finite makes the
/// sample invalid.
void appendGazeRow(const gaze::GazeSample& sample, std::string& text);

/// "none", "history", "scene" or "restart".
[[nodiscard]] std::string_view resetName(Reset reset);

}  // namespace macula::recording
