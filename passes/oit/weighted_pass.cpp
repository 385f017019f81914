#include "passes/oit/weighted_pass.h"

#include "engine/gl/render_state.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool WeightedPass::wanted() const {
  return plan_.method->insertion == Insertion::Weighted;
}

void WeightedPass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::ShadowMap, Use::Texture);
  readsDepth(d, Use::DepthTarget);
  d.writes(Resource::WeightedColors, Use::ColorTarget);
  d.writes(Resource::TailSums, Use::ColorTarget);
}

void WeightedPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  variants_.prepare(in.gpu->transparent().runs, "oit/weighted.frag", lightingDefines(in.facts), {},
                    programs);
}

void WeightedPass::run(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  bindTargets(context, {Resource::WeightedColors, Resource::TailSums}, plan_.depth());
  gl::apply({.depthTest = true, .blend = gl::Blend::Add});
  constexpr GLfloat kNone[4]{};
  glClearBufferfv(GL_COLOR, 0, kNone);
  glClearBufferfv(GL_COLOR, 1, kNone);
  gpu.bindLights();
  context.bindTexture(TEX_SHADOW_MAP, Resource::ShadowMap);
  variants_.draw(gpu, gpu.transparent(), gpu.transparent().runs);
}

}  // namespace macula::passes
