#include "passes/oit/blend_pass.h"

#include "engine/gl/render_state.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool BlendPass::wanted() const {
  return plan_.method->insertion == Insertion::Blended;
}

void BlendPass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::ShadowMap, Use::Texture);
  readsDepth(d, Use::DepthTarget);
  modifiesColor(d, Use::ColorTarget);
}

void BlendPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  variants_.prepare(in.gpu->transparent().runs, "oit/blend.frag", lightingDefines(in.facts), {},
                    programs);
}

void BlendPass::run(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  bindTargets(context, {plan_.color()}, plan_.depth());
  gl::apply({.depthTest = true, .blend = gl::Blend::Premultiplied});
  gpu.bindLights();
  context.bindTexture(TEX_SHADOW_MAP, Resource::ShadowMap);
  variants_.draw(gpu, gpu.transparent(), gpu.transparent().runs);
}

}  // namespace macula::passes
