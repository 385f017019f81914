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

/// Quality controls: what a controller may set from frame to frame. Nothing is allocated for them.
/// History stays valid, but that of reduced-rate transparency is of one r.
struct QualityControls {
  float resize = 0.0F;      ///< resize factor r, 1 to 8; 0: lod.r
  float foveaSlope = 1.0F;  ///< factor on foveation.slope, >= 1
  float layerShare = 1.0F;  ///< of the layers that the k-buffer's budget would give, 0 < x <= 1

  bool operator==(const QualityControls&) const = default;
};

/// Inputs of one frame. Without `gpu` (no GL) it still answers Pass::hasWork().
struct FrameInputs {
  scene::SceneFacts facts;
  const scene::GpuScene* gpu = nullptr;
  scene::View view;
  glm::ivec2 outputSize{0};   ///< pixels of the window or image
  glm::ivec2 displaySize{0};  ///< samples: outputSize times supersampling
  gaze::PointOfInterest gaze;
  QualityControls controls;
  std::uint32_t frameIndex = 0;
  bool historyValid = false;  ///< the last frame was drawn, at this size, without a camera cut
};

}  // namespace macula::frame
