// The members of a batch along the camera's path, beside the exact frames.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "chart_contender.h"
#include "engine/gaze/source.h"
#include "engine/scene/camera_path.h"

namespace macula::tools {

/// The frames of a path: frame i is at i / fps seconds.
struct PathTrack {
  const scene::CameraPath& camera;
  gaze::GazeSource& gaze;
  int frames = 0;
  double fps = 0.0;
};

/// Draws frame after frame by the exact renderer and by every member, so that one exact frame is
/// in memory at a time, and gives each point its "path". Members start with the history that they
/// have; nothing is timed. A member that the machine refuses on the way gets {"reason"}.
/// @param members null where there is none; its point stays as it is
/// @param goesOn called after each frame of all; the walk ends early where it returns false
/// @returns whether all exact frames were exact
/// @throws InputError where the exact renderer is refused
bool walkPath(const PathTrack& track, Contender& exact,
              std::span<const std::unique_ptr<Contender>> members,
              std::span<experiment::Point> points, const std::function<bool()>& goesOn);

}  // namespace macula::tools
