#include "passes/oit/demand_pass.h"

#include "passes/oit/bidding.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool DemandPass::wanted() const {
  return plan_.auctions();
}

void DemandPass::declareWork(frame::PassDeclaration& d) const {
  if (bidsAreIn()) {
    d.reads(plan_.countResource(), Use::Texture);
    d.reads(Resource::SlotBids, Use::Image);
  } else {
    declareBids(d, plan_);
    d.writes(Resource::SlotBids, Use::Image);
  }
  d.writes(Resource::StripSums, Use::Storage);
  d.reads(Resource::OitTotals, Use::Storage);
}

void DemandPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  gl::Defines defines = bidDefines(plan_);
  if (bidsAreIn()) defines.emplace_back("BIDS_IN", "1");
  program_ = programs.get({{"oit/demand.comp"}, defines, {}});
}

void DemandPass::run(frame::PassContext& context) {
  glUseProgram(program_);
  if (bidsAreIn()) {
    context.bindTexture(TEX_INPUT0, plan_.countResource());
    context.bindImage(IMG_0, Resource::SlotBids, GL_READ_ONLY);
  } else {
    bindBids(context, plan_);
    context.bindImage(IMG_0, Resource::SlotBids, GL_WRITE_ONLY);
  }
  context.bindStorage(SSBO_STRIP_SUMS, Resource::StripSums);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  dispatchStrips(context, plan_.size);
}

}  // namespace macula::passes
