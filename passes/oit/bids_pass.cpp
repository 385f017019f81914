#include "passes/oit/bids_pass.h"

#include "passes/oit/bidding.h"
#include "passes/oit/covered_lists.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool BidsPass::wanted() const {
  return plan_.auctions() && plan_.slices();
}

void BidsPass::declareWork(frame::PassDeclaration& d) const {
  declareBids(d, plan_);
  declareCoveredTiles(d);
  d.writes(Resource::SlotBids, Use::Image);
}

void BidsPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  gl::Defines defines = bidDefines(plan_);
  defines.push_back(listedTileDefine(plan_));
  program_ = programs.get({{"oit/bids.comp"}, defines, {}});
}

void BidsPass::run(frame::PassContext& context) {
  glUseProgram(program_);
  bindBids(context, plan_);
  context.bindImage(IMG_0, Resource::SlotBids, GL_WRITE_ONLY);
  dispatchCoveredTiles(context);
}

}  // namespace macula::passes
