#include "passes/oit/count_pass.h"

#include "engine/gl/render_state.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool CountPass::wanted() const {
  if (plan_.gathersColors()) return false;  // counted with its colours
  return (plan_.method->counts() && !plan_.predictsCounts()) || plan_.culls();
}

void CountPass::declareWork(frame::PassDeclaration& d) const {
  readsDepth(d, Use::DepthTarget);
  d.writes(Resource::FragmentCount, Use::ColorTarget);
  if (plan_.findsRange()) d.writes(Resource::DepthRange, Use::ColorTarget);
}

void CountPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  gl::Defines defines{{"POSITION_ONLY", "1"}};
  if (plan_.findsRange()) defines.emplace_back("RANGE", "1");
  variants_.prepare(in.gpu->transparent().depthRuns, "oit/count.frag", defines, {}, programs);
}

void CountPass::run(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  constexpr GLfloat kNone[4]{};
  if (plan_.findsRange()) {
    bindTargets(context, {Resource::FragmentCount, Resource::DepthRange}, plan_.depth());
    gl::apply({.depthTest = true, .blend = gl::Blend::AddThenMax});
    constexpr GLfloat kNoDepth[4]{-2.0F, -2.0F, 0.0F, 0.0F};  // less than any
    glClearBufferfv(GL_COLOR, 1, kNoDepth);
  } else {
    bindTargets(context, {Resource::FragmentCount}, plan_.depth());
    gl::apply({.depthTest = true, .blend = gl::Blend::Add});
  }
  glClearBufferfv(GL_COLOR, 0, kNone);
  variants_.draw(gpu, gpu.transparent(), gpu.transparent().depthRuns);
}

}  // namespace macula::passes
