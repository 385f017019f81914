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
  declareBids(d, plan_);
  d.writes(Resource::SlotBids, Use::Image);
  d.writes(Resource::StripSums, Use::Storage);
  d.reads(Resource::OitTotals, Use::Storage);
}

void DemandPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get({{"oit/demand.comp"}, bidDefines(plan_), {}});
}

void DemandPass::run(frame::PassContext& context) {
  glUseProgram(program_);
  bindBids(context, plan_);
  context.bindImage(IMG_0, Resource::SlotBids, GL_WRITE_ONLY);
  context.bindStorage(SSBO_STRIP_SUMS, Resource::StripSums);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  dispatchStrips(context, plan_.size);
}

}  // namespace macula::passes
