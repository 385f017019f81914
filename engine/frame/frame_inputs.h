// What one frame is drawn from.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

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
  glm::vec2 gaze{0.5F};       ///< point of interest, 0..1 of the window from the top left
  std::uint32_t frameIndex = 0;
  bool historyValid = false;  ///< the last frame was drawn, at this size, without a camera cut
};

}  // namespace macula::frame
