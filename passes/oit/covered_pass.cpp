#include "passes/oit/covered_pass.h"

#include "passes/oit/covered_lists.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

std::string_view CoveredPass::name() const {
  return list_ == LIST_OF_TILES ? "oit.covered" : "oit.sample";
}

bool CoveredPass::wanted() const {
  return list_ == LIST_OF_TILES ? plan_.listsTiles() : plan_.auctions();
}

void CoveredPass::declareWork(frame::PassDeclaration& d) const {
  d.reads(plan_.countResource(), Use::Texture);
  d.writes(listResource(list_), Use::Storage);
  d.modifies(Resource::OitTotals, Use::Storage);
}

void CoveredPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  const gl::Defines::value_type places =
      list_ == LIST_OF_TILES ? listedTileDefine(plan_) : gl::Defines::value_type("SAMPLED", "1");
  program_ = programs.get({{"oit/covered.comp"}, {places}, {}});
}

void CoveredPass::run(frame::PassContext& context) {
  glUseProgram(program_);
  context.bindTexture(TEX_INPUT0, plan_.countResource());
  context.bindStorage(SSBO_COVERED, listResource(list_));
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  const int side = list_ == LIST_OF_TILES ? plan_.listedTile() : priceStride(plan_.size);
  dispatchStrips(context, (plan_.size + side - 1) / side);
}

}  // namespace macula::passes
