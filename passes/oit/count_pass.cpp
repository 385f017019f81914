#include "passes/oit/count_pass.h"

#include "engine/gl/render_state.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool CountPass::wanted() const {
  return plan_.method->counts();
}

void CountPass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::Depth, Use::DepthTarget);
  d.writes(Resource::FragmentCount, Use::ColorTarget);
}

void CountPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  variants_.prepare(in.gpu->transparent().depthRuns, "oit/count.frag", {{"POSITION_ONLY", "1"}}, {},
                    programs);
}

void CountPass::execute(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  context.bindTargets({Resource::FragmentCount}, Resource::Depth);
  gl::apply({.depthTest = true, .blend = gl::Blend::Add});
  constexpr GLfloat kNone[4]{};
  glClearBufferfv(GL_COLOR, 0, kNone);
  variants_.draw(gpu, gpu.transparent(), gpu.transparent().depthRuns);
}

}  // namespace macula::passes
