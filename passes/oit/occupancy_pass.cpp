#include "passes/oit/occupancy_pass.h"

#include "engine/gl/render_state.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool OccupancyPass::wanted() const {
  return plan_.culls();
}

void OccupancyPass::declareWork(frame::PassDeclaration& d) const {
  readsDepth(d, Use::DepthTarget);
  d.reads(Resource::FragmentCount, Use::Texture);
  d.reads(Resource::DepthRange, Use::Texture);
  if (plan_.method->hasRanges()) d.reads(Resource::FragmentRange, Use::Image);
  d.writes(Resource::Occupancy, Use::Storage);
}

void OccupancyPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  gl::Defines defines{{"POSITION_ONLY", "1"}};
  if (plan_.method->hasRanges()) defines.emplace_back("RANGES", "1");
  if (plan_.sync == SyncMode::Ordered) defines.emplace_back("SYNC_ORDERED", "1");
  variants_.prepare(in.gpu->transparent().depthRuns, "oit/occupancy.frag", defines, {}, programs);
  emptied_ = false;
}

void OccupancyPass::run(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  // Whoever counts the bits leaves the map empty again, which is cheaper than to clear all of it.
  if (!emptied_) context.resources().clear(Resource::Occupancy);
  emptied_ = true;
  bindTargets(context, {}, plan_.depth());
  gl::apply({.depthTest = true});
  context.bindTexture(TEX_INPUT0, Resource::FragmentCount);
  context.bindTexture(TEX_INPUT1, Resource::DepthRange);
  if (plan_.method->hasRanges()) context.bindImage(IMG_0, Resource::FragmentRange, GL_READ_ONLY);
  context.bindStorage(SSBO_OCCUPANCY, Resource::Occupancy);
  variants_.draw(gpu, gpu.transparent(), gpu.transparent().depthRuns);
}

}  // namespace macula::passes
