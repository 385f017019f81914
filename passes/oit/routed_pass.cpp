#include "passes/oit/routed_pass.h"

#include "engine/core/error.h"
#include "engine/gl/render_state.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool RoutedPass::wanted() const {
  return plan_.method->insertion == Insertion::StencilRouted;
}

void RoutedPass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::ShadowMap, Use::Texture);
  readsTestedDepth(d, Use::Texture);
  d.uses(Resource::RoutedStencil, Use::DepthTarget);
  d.writes(Resource::RoutedKeys, Use::ColorTarget);
  d.writes(Resource::RoutedColors, Use::ColorTarget);
}

void RoutedPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  routing_ = routingProgram(programs);
  variants_.prepare(in.gpu->transparent().runs, "oit/routed.frag", lightingDefines(in.facts), {},
                    programs);
  if (mode_ == RoutingMode::None) mode_ = checkStencilRouting(programs);
  if (mode_ == RoutingMode::None) {
    failInput(
        "oit.method: this GPU's stencil test does not route fragments to samples; use "
        "kb-fixed");
  }
}

void RoutedPass::run(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  bindTargets(context, {Resource::RoutedKeys, Resource::RoutedColors}, Resource::RoutedStencil);
  constexpr GLuint kEmpty[4]{NO_KEY, NO_KEY, NO_KEY, NO_KEY};
  glClearBufferuiv(GL_COLOR, 0, kEmpty);
  const Resource depth = plan_.testedDepth();
  prepareRouting(routing_, fullScreen_, context.resources().texture(depth).id(), plan_.layers);
  beginRouting(mode_);
  gpu.bindLights();
  context.bindTexture(TEX_SHADOW_MAP, Resource::ShadowMap);
  variants_.draw(gpu, gpu.transparent(), gpu.transparent().runs);
  endRouting();
}

}  // namespace macula::passes
