#include "passes/gbuffer_pass.h"

#include <fmt/format.h>

#include "engine/core/plural.h"
#include "engine/gl/render_state.h"
#include "passes/resources.h"

namespace macula::passes {

void GBufferPass::declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const {
  d.scene();
  d.depth(kDepth, frame::Access::Write);
  d.color(0, kNormal, frame::Access::Write);
  d.color(1, kBaseColor, frame::Access::Write);
  d.color(2, kSurface, frame::Access::Write);
  d.color(3, kEmissive, frame::Access::Write);
}

bool GBufferPass::hasWork(const frame::FrameInputs& in) const {
  return in.facts.opaqueTriangles > 0;
}

std::string GBufferPass::reason(const frame::FrameInputs& in) const {
  return hasWork(in) ? counted(in.facts.opaqueTriangles, "opaque triangle") : "nothing opaque";
}

void GBufferPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  variants_.prepare(in.gpu->opaque().runs, "gbuffer.frag", {}, {}, programs);
}

void GBufferPass::execute(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  gl::apply({.depthTest = true, .depthWrite = true, .encodeSrgb = true});
  // Only depth is cleared: where it stays 0, no pass reads the rest.
  constexpr GLfloat kFar = 0.0F;
  glClearBufferfv(GL_DEPTH, 0, &kFar);
  variants_.draw(gpu, gpu.opaque(), gpu.opaque().runs);
}

}  // namespace macula::passes
