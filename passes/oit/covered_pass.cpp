#include "passes/oit/covered_pass.h"

#include "passes/oit/covered_tiles.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool CoveredPass::wanted() const {
  return plan_.listsTiles();
}

void CoveredPass::declareWork(frame::PassDeclaration& d) const {
  d.reads(plan_.countResource(), Use::Texture);
  d.writes(Resource::CoveredTiles, Use::Storage);
  d.modifies(Resource::OitTotals, Use::Storage);
}

void CoveredPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get({{"oit/covered.comp"}, {listedTileDefine(plan_)}, {}});
}

void CoveredPass::run(frame::PassContext& context) {
  glUseProgram(program_);
  context.bindTexture(TEX_INPUT0, plan_.countResource());
  context.bindStorage(SSBO_COVERED_TILES, Resource::CoveredTiles);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  const int tile = plan_.listedTile();
  dispatchStrips(context, (plan_.size + tile - 1) / tile);
}

}  // namespace macula::passes
