// Fills a frame's record from the renderer's result: the one place for every subcommand that
// measures.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/gaze/point_of_interest.h"
#include "engine/measure/frame_record.h"
#include "passes/frame_renderer.h"

namespace macula::tools {

/// Every metric that the renderer knows of its last frame. What the caller alone knows (index,
/// time, gaze, errors, the image's hash) is left to it.
[[nodiscard]] measure::FrameRecord recordOf(const passes::FrameRenderer& renderer,
                                            const passes::FrameResult& result);

/// Sets the metrics gaze.* and fovea.*, all but the error.
void setGaze(measure::FrameRecord& record, const gaze::PointOfInterest& point);

/// Bytes of each buffer and texture of transparency by name, while it is alive. Where lives do not
/// meet, buffers share memory, so these add up to the metric bytes.total or more.
[[nodiscard]] std::vector<std::pair<std::string, std::uint64_t>> transparencyBytes(
    const passes::FrameRenderer& renderer);

}  // namespace macula::tools
