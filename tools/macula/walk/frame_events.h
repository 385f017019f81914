// All that decides a frame, complete just before it is drawn: what a recording has to keep.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "engine/gaze/point_of_interest.h"
#include "engine/scene/scene.h"
#include "engine/settings/entry.h"

namespace macula::tools {

struct FrameEvents {
  int index = 0;              ///< from 0, over all scenes of the walk
  double timeSeconds = 0.0;   ///< since the walk began
  float deltaSeconds = 0.0F;  ///< since the frame before
  glm::ivec2 windowSize{0};   ///< pixels
  glm::ivec2 pictureSize{0};  ///< pixels that a method draws: less where two stand side by side
  scene::Camera camera;
  gaze::PointOfInterest gaze;
  bool cut = false;           ///< the camera jumped
  bool resized = false;       ///< the picture has another size than before; history is void
  bool sceneChanged = false;  ///< this is the scene's first frame; history is void
  std::string scene;          ///< name or file
  /// Settings that changed before this frame and were not refused; history is void after any.
  std::vector<const settings::Entry*> changed;
};

}  // namespace macula::tools
