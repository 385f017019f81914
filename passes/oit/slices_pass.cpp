#include "passes/oit/slices_pass.h"

#include "engine/gl/render_state.h"
#include "passes/oit/bidding.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool SlicesPass::wanted() const {
  return plan_.slices();
}

void SlicesPass::declareWork(frame::PassDeclaration& d) const {
  readsDepth(d, plan_.importance.tile > 1 ? Use::Texture : Use::DepthTarget);
  if (plan_.importance.tile > 1) d.uses(Resource::TileDepth, Use::DepthTarget);
  d.reads(Resource::DepthRange, Use::Texture);
  d.modifies(Resource::SliceSums, Use::Storage);
}

void SlicesPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  gl::Defines defines{{"VERTEX_LIGHT", "1"}};
  addSliceDefines(defines, plan_);
  if (plan_.sync == SyncMode::Ordered) defines.emplace_back("SYNC_ORDERED", "1");
  if (in.facts.environment) defines.emplace_back("ENVIRONMENT", "1");  // its ambient light counts
  if (plan_.usesNetwork()) defines.emplace_back("LEARNED", "1");
  variants_.prepare(in.gpu->transparent().runs, "oit/slices.frag", defines, {}, programs);
  tileProgram_ = programs.get({{"oit/full_screen.vert", "oit/tile_depth.frag"}, {}, {}});
}

void SlicesPass::drawTileDepth(frame::PassContext& context) {
  context.bindTargets({}, Resource::TileDepth, tiles());
  context.bindTexture(TEX_INPUT0, plan_.depth());
  gl::apply({.depthTest = true, .depthFunc = GL_ALWAYS, .depthWrite = true});
  fullScreen_.draw(tileProgram_);
}

void SlicesPass::run(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  const bool tiled = plan_.importance.tile > 1;
  if (tiled) drawTileDepth(context);
  context.bindTargets({}, tiled ? Resource::TileDepth : plan_.depth(), tiles());
  gl::apply({.depthTest = true});
  gpu.bindLights();
  context.bindTexture(TEX_INPUT1, Resource::DepthRange);
  context.bindStorage(SSBO_SLICES, Resource::SliceSums);
  variants_.draw(gpu, gpu.transparent(), gpu.transparent().runs);
}

}  // namespace macula::passes
