#include "passes/oit/capture_pass.h"

#include "engine/gl/render_state.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool CapturePass::wanted() const {
  return plan_.method->stores() && plan_.method->insertion != Insertion::StencilRouted;
}

void CapturePass::declareWork(frame::PassDeclaration& d) const {
  const Insertion insertion = plan_.method->insertion;
  d.reads(Resource::ShadowMap, Use::Texture);
  readsTestedDepth(d, Use::DepthTarget);
  if (plan_.method->hasRanges()) d.reads(Resource::FragmentRange, Use::Image);
  if (insertion != Insertion::AtomicMin) d.modifies(Resource::FragmentFill, Use::Image);
  if (plan_.keepsFrontNormal()) d.modifies(Resource::FrontNormal, Use::Image);
  if (plan_.usesLocks()) d.consumes(Resource::FragmentLock, Use::Image);
  // The keys of kb-atomic and the tails that an allocation has emptied are there already.
  const bool begun =
      insertion == Insertion::AtomicMin || (plan_.tailInSlot() && !plan_.dynamicTail());
  const auto store = [&](Resource r, bool modified) {
    modified ? d.modifies(r, Use::Storage) : d.writes(r, Use::Storage);
  };
  store(Resource::FragmentKeys, begun);
  if (!plan_.packed()) {
    store(Resource::FragmentColors, begun && insertion != Insertion::AtomicMin);
  }
  if (insertion == Insertion::Linked) d.writes(Resource::FragmentLinks, Use::Storage);
  if (plan_.denseTail()) d.writes(Resource::TailSums, Use::ColorTarget);
  if (plan_.predictsCounts()) d.writes(Resource::FragmentCount, Use::ColorTarget);
  d.modifies(Resource::OitTotals, Use::Storage);
}

void CapturePass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  gl::Defines defines = definesOf(plan_);
  if (plan_.method->insertion != Insertion::AtomicMin) {
    for (auto& define : syncDefines(plan_)) defines.push_back(define);
  }
  if (plan_.keepsFrontNormal()) defines.emplace_back("FRONT_NORMAL", "1");
  if (plan_.predictsCounts()) defines.emplace_back("COUNT_OUT", "1");
  for (auto& define : lightingDefines(in.facts)) defines.push_back(define);
  std::vector<std::string> extensions;
  if (plan_.sync == SyncMode::Interlock && plan_.sorted()) {
    extensions.emplace_back("GL_ARB_fragment_shader_interlock");
  }
  variants_.prepare(in.gpu->transparent().runs, "oit/capture.frag", defines, extensions, programs);
}

void CapturePass::run(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  const Insertion insertion = plan_.method->insertion;
  const Resource depth = plan_.testedDepth();
  if (plan_.denseTail() || plan_.predictsCounts()) {
    bindTargets(context, {plan_.denseTail() ? Resource::TailSums : Resource::FragmentCount}, depth);
    gl::apply({.depthTest = true, .blend = gl::Blend::Add});
    constexpr GLfloat kNone[4]{};
    glClearBufferfv(GL_COLOR, 0, kNone);
  } else {
    bindTargets(context, {}, depth);
    gl::apply({.depthTest = true});
  }
  gpu.bindLights();
  context.bindTexture(TEX_SHADOW_MAP, Resource::ShadowMap);
  if (plan_.method->hasRanges()) context.bindImage(IMG_0, Resource::FragmentRange, GL_READ_ONLY);
  if (insertion != Insertion::AtomicMin) {
    context.bindImage(IMG_1, Resource::FragmentFill, GL_READ_WRITE);
  }
  if (plan_.keepsFrontNormal()) context.bindImage(IMG_2, Resource::FrontNormal, GL_WRITE_ONLY);
  if (plan_.usesLocks()) context.bindImage(IMG_3, Resource::FragmentLock, GL_READ_WRITE);
  context.bindStorage(SSBO_FRAGMENT_KEYS, Resource::FragmentKeys);
  if (!plan_.packed()) context.bindStorage(SSBO_FRAGMENT_COLORS, Resource::FragmentColors);
  if (insertion == Insertion::Linked) {
    context.bindStorage(SSBO_FRAGMENT_LINKS, Resource::FragmentLinks);
  }
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  variants_.draw(gpu, gpu.transparent(), gpu.transparent().runs);
}

}  // namespace macula::passes
