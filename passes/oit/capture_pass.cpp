#include "passes/oit/capture_pass.h"

#include "engine/gl/render_state.h"
#include "passes/oit/common.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void CapturePass::declare(frame::PassDeclaration& d) const {
  if (!plan_.method->stores()) return;
  d.reads(Resource::ShadowMap, Use::Texture);
  d.reads(Resource::Depth, Use::DepthTarget);
  d.reads(Resource::FragmentRange, Use::Image);
  d.modifies(Resource::FragmentFill, Use::Image);
  if (plan_.method->keepsFrontNormal()) d.modifies(Resource::FrontNormal, Use::Image);
  if (plan_.usesLocks()) d.consumes(Resource::FragmentLock, Use::Image);
  d.writes(Resource::FragmentKeys, Use::Storage);
  d.writes(Resource::FragmentColors, Use::Storage);
  d.modifies(Resource::OitTotals, Use::Storage);
}

bool CapturePass::hasWork(const frame::FrameInputs& in) const {
  return in.facts.transparentTriangles > 0 && plan_.method->stores();
}

std::string CapturePass::reason(const frame::FrameInputs& in) const {
  return transparencyReason(in, plan_.method->stores(), plan_.method->id);
}

void CapturePass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  gl::Defines defines = definesOf(plan_);
  for (auto& define : lightingDefines(in.facts)) defines.push_back(define);
  std::vector<std::string> extensions;
  if (plan_.sync == SyncMode::Interlock && plan_.method->insertion == Insertion::Sorted) {
    extensions.emplace_back("GL_ARB_fragment_shader_interlock");
  }
  variants_.prepare(in.gpu->transparent().runs, "oit/capture.frag", defines, extensions, programs);
}

void CapturePass::execute(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  context.bindTargets({}, Resource::Depth);
  gl::apply({.depthTest = true});
  gpu.bindLights();
  context.bindTexture(TEX_SHADOW_MAP, Resource::ShadowMap);
  context.bindImage(IMG_0, Resource::FragmentRange, GL_READ_ONLY);
  context.bindImage(IMG_1, Resource::FragmentFill, GL_READ_WRITE);
  if (plan_.method->keepsFrontNormal()) {
    context.bindImage(IMG_2, Resource::FrontNormal, GL_WRITE_ONLY);
  }
  if (plan_.usesLocks()) context.bindImage(IMG_3, Resource::FragmentLock, GL_READ_WRITE);
  context.bindStorage(SSBO_FRAGMENT_KEYS, Resource::FragmentKeys);
  context.bindStorage(SSBO_FRAGMENT_COLORS, Resource::FragmentColors);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  variants_.draw(gpu, gpu.transparent(), gpu.transparent().runs);
}

}  // namespace macula::passes
