// The numbers of the last frame of a walk, for `--json`.
#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/gaze/point_of_interest.h"
#include "passes/frame_renderer.h"

namespace macula::tools {

/// Mean k(p) over a square of up to 64 x 64 pixels around a place of the last frame, cut off at the
/// image's edges; none where the method stores no fragments.
/// @param place 0..1 of the window from the top left
[[nodiscard]] std::optional<double> meanK(const passes::FrameRenderer& renderer, glm::vec2 place,
                                          int samplesPerAxis);

/// @param frames number of frames drawn so far
[[nodiscard]] nlohmann::ordered_json describeWalk(const passes::FrameRenderer& renderer,
                                                  const passes::RenderSettings& settings,
                                                  const passes::FrameResult& result,
                                                  const gaze::PointOfInterest& point,
                                                  const std::vector<glm::vec2>& probes, int frames);

}  // namespace macula::tools
