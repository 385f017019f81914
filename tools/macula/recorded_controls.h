// The quality controls of a frame as a recording holds them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/frame/frame_inputs.h"
#include "engine/recording/recording.h"

namespace macula::tools {

/// Those that a controller has set, by the names of control::kControlOrder; none where all rest.
[[nodiscard]] std::vector<std::pair<std::string, double>> recordedControls(
    const frame::QualityControls& controls);

/// What recordedControls() was made from, bit for bit.
/// @param lodResize lod.r of the frame: r of a frame without controls is its own, unless it is 1
/// @param place file and line, for messages
/// @throws InputError for an unknown control or an impossible value
[[nodiscard]] frame::QualityControls replayedControls(const recording::Frame& frame,
                                                      double lodResize, const std::string& place);

}  // namespace macula::tools
