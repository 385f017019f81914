// The members of a batch along the camera's path, beside the exact frames.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "chart_contender.h"
#include "common.h"

namespace macula::tools {

/// Draws frame after frame by the exact renderer and by every member, so that one exact frame is
/// in memory at a time, and gives each point its "path". Members start with the history that they
/// have; nothing is timed. A member that the machine refuses on the way gets {"reason"}.
/// @param fps frames a second of the path
/// @param members null where there is none; its point stays as it is
/// @param progress advanced by each frame
/// @returns whether all exact frames were exact; none where the user interrupted
/// @throws InputError where the exact renderer is refused
std::optional<bool> walkPath(recording::FrameSource& frames, double fps, Contender& exact,
                             std::span<const std::unique_ptr<Contender>> members,
                             std::span<experiment::Point> points, ProgressBar& progress);

}  // namespace macula::tools
