#include "passes/oit/count_pass.h"

#include "engine/gl/render_state.h"
#include "passes/oit/common.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void CountPass::declare(frame::PassDeclaration& d) const {
  if (!plan_.method->counts()) return;
  d.reads(Resource::Depth, Use::DepthTarget);
  d.writes(Resource::FragmentCount, Use::ColorTarget);
}

bool CountPass::hasWork(const frame::FrameInputs& in) const {
  return in.facts.transparentTriangles > 0 && plan_.method->counts();
}

std::string CountPass::reason(const frame::FrameInputs& in) const {
  return transparencyReason(in, plan_.method->counts(), plan_.method->id);
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
