// What one frame is drawn from.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "engine/gaze/point_of_interest.h"
#include "engine/scene/scene_facts.h"
#include "engine/scene/view.h"

namespace macula::scene {
class GpuScene;
}

namespace macula::frame {

/// Inputs of one frame. Without `gpu` (no GL) it still answers Pass::hasWork().
struct FrameInputs {
  scene::SceneFacts facts;
  const scene::GpuScene* gpu = nullptr;
  scene::View view;
  glm::ivec2 outputSize{0};   ///< pixels of the window or image
  glm::ivec2 displaySize{0};  ///< samples: outputSize times supersampling
  gaze::PointOfInterest gaze;
  std::uint32_t frameIndex = 0;
  bool historyValid = false;  ///< the last frame was drawn, at this size, without a camera cut
};

}  // namespace macula::frame
