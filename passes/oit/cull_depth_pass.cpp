#include "passes/oit/cull_depth_pass.h"

#include "engine/gl/render_state.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool CullDepthPass::wanted() const {
  return plan_.culls();
}

void CullDepthPass::declareWork(frame::PassDeclaration& d) const {
  readsDepth(d, Use::Texture);
  d.reads(Resource::FragmentCount, Use::Texture);
  d.reads(Resource::DepthRange, Use::Texture);
  if (plan_.method->hasRanges()) d.reads(Resource::FragmentRange, Use::Image);
  d.consumes(Resource::Occupancy, Use::Storage);
  d.writes(Resource::CullDepth, Use::DepthTarget);
}

void CullDepthPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  gl::Defines defines;
  if (plan_.method->hasRanges()) defines.emplace_back("RANGES", "1");
  program_ = programs.get({{"oit/full_screen.vert", "oit/cull_depth.frag"}, defines, {}});
}

void CullDepthPass::run(frame::PassContext& context) {
  bindTargets(context, {}, Resource::CullDepth);
  gl::apply({.depthTest = true, .depthFunc = GL_ALWAYS, .depthWrite = true});
  context.bindTexture(TEX_INPUT0, Resource::FragmentCount);
  context.bindTexture(TEX_INPUT1, Resource::DepthRange);
  context.bindTexture(TEX_INPUT2, plan_.depth());
  if (plan_.method->hasRanges()) context.bindImage(IMG_0, Resource::FragmentRange, GL_READ_ONLY);
  context.bindStorage(SSBO_OCCUPANCY, Resource::Occupancy);
  fullScreen_.draw(program_);
}

}  // namespace macula::passes
