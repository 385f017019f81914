#include "passes/oit/blend_pass.h"

#include "engine/gl/render_state.h"
#include "passes/oit/common.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void BlendPass::declare(frame::PassDeclaration& d) const {
  if (plan_.method->stores()) return;
  d.reads(Resource::ShadowMap, Use::Texture);
  d.reads(Resource::Depth, Use::DepthTarget);
  d.modifies(Resource::HdrColor, Use::ColorTarget);
}

bool BlendPass::hasWork(const frame::FrameInputs& in) const {
  return in.facts.transparentTriangles > 0 && !plan_.method->stores();
}

std::string BlendPass::reason(const frame::FrameInputs& in) const {
  return transparencyReason(in, !plan_.method->stores(), plan_.method->id);
}

void BlendPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  variants_.prepare(in.gpu->transparent().runs, "oit/blend.frag", lightingDefines(in.facts), {},
                    programs);
}

void BlendPass::execute(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  context.bindTargets({Resource::HdrColor}, Resource::Depth);
  gl::apply({.depthTest = true, .blend = gl::Blend::Premultiplied});
  gpu.bindLights();
  context.bindTexture(TEX_SHADOW_MAP, Resource::ShadowMap);
  variants_.draw(gpu, gpu.transparent(), gpu.transparent().runs);
}

}  // namespace macula::passes
