#include "passes/gbuffer_pass.h"

#include <fmt/format.h>

#include "engine/core/plural.h"
#include "engine/gl/render_state.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void GBufferPass::declare(frame::PassDeclaration& d) const {
  d.writes(Resource::Depth, Use::DepthTarget);
  d.writes(Resource::Normal, Use::ColorTarget);
  d.writes(Resource::BaseColor, Use::ColorTarget);
  d.writes(Resource::Surface, Use::ColorTarget);
  d.writes(Resource::Emissive, Use::ColorTarget);
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
  context.bindTargets(
      {Resource::Normal, Resource::BaseColor, Resource::Surface, Resource::Emissive},
      Resource::Depth);
  gl::apply({.depthTest = true, .depthWrite = true, .encodeSrgb = true});
  // Only depth is cleared: where it stays 0, nobody looks at the rest.
  constexpr GLfloat kFar = 0.0F;
  glClearBufferfv(GL_DEPTH, 0, &kFar);
  variants_.draw(gpu, gpu.opaque(), gpu.opaque().runs);
}

}  // namespace macula::passes
