// The numbers of the last frame of a walk, for `--json`.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "frame_control.h"
#include "passes/frame_renderer.h"
#include "walk/error_check.h"
#include "walk/frame_events.h"
#include "walk/second_view.h"

namespace macula::tools {

/// Mean k(p) over a square of up to 64 x 64 pixels around a place of the last frame, cut off at the
/// image's edges; none where the method stores no fragments.
/// @param place 0..1 of the window from the top left
[[nodiscard]] std::optional<double> meanK(const passes::FrameRenderer& renderer, glm::vec2 place,
                                          int samplesPerAxis);

/// What a report is made of.
struct WalkReport {
  const passes::FrameRenderer& renderer;
  const passes::FrameResult& result;
  const passes::RenderSettings& settings;
  const FrameEvents& events;
  const SecondView& second;
  const ErrorCheck& errors;
  std::string gazeSource;
  std::vector<std::string> gazeWarnings;  ///< of a recording that is played
  std::string tab;                        ///< that is open; empty: panels are hidden
  std::optional<int> searchHits;
  std::string message;  ///< the last one that was shown
  std::string commandLine;
  int frames = 0;                      ///< drawn while nothing was loading or being measured
  int loadingFrames = 0;               ///< drawn while a scene was loading
  std::optional<double> firstImageMs;  ///< from the window to something of the scene
  std::optional<double> firstFrameMs;  ///< from the window to the first whole frame
  bool playing = false;                ///< a camera path
  const FrameControl& control;
  std::optional<double> framesPerSecond;  ///< from present to present
  std::uint64_t blockingCalls = 0;        ///< by which the last frame may have waited for the GPU
};

[[nodiscard]] nlohmann::ordered_json describeWalk(const WalkReport& report,
                                                  const std::vector<glm::vec2>& probes);

}  // namespace macula::tools
