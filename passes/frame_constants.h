// The constants that the shaders of a frame read (shaders/shared/frame_constants.h).
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "engine/frame/frame_inputs.h"
#include "engine/gl/objects.h"
#include "passes/lod/plan.h"
#include "passes/oit/plan.h"

namespace macula::passes {

/// What the constants of a frame follow from.
struct ConstantSources {
  const frame::FrameInputs& inputs;
  const OitPlan& plan;
  const LodPlan& lod;
  glm::vec3 background;  ///< linear RGB
  const glm::mat4& lastViewProjection;
};

/// One uniform buffer for the samples of the image, one for the texels of reduced-rate
/// transparency.
class FrameConstantBuffers {
 public:
  FrameConstantBuffers();
  /// The second one only where the plan is at a reduced rate.
  void upload(const ConstantSources& sources);
  /// By frame::Raster.
  [[nodiscard]] std::array<GLuint, 2> ids() const { return {image_.id(), reduced_.id()}; }

 private:
  gl::Buffer image_;
  gl::Buffer reduced_;
};

}  // namespace macula::passes
