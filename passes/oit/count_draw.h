// Counts transparent fragments into the bound target by additive blending.
#pragma once

#include "engine/gl/render_state.h"
#include "passes/scene_draw.h"

namespace macula::passes {

class CountDraw {
 public:
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
    variants_.prepare(in.gpu->transparent().depthRuns, "oit/count.frag", {{"POSITION_ONLY", "1"}},
                      {}, programs);
  }
  /// Clears colour target 0 and counts the fragments that pass the bound depth.
  void draw(const scene::GpuScene& gpu) const {
    gl::apply({.depthTest = true, .blend = gl::Blend::Add});
    constexpr GLfloat kNone[4]{};
    glClearBufferfv(GL_COLOR, 0, kNone);
    variants_.draw(gpu, gpu.transparent(), gpu.transparent().depthRuns);
  }

 private:
  SceneVariants variants_;
};

}  // namespace macula::passes
