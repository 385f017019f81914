#include "passes/oit/price_pass.h"

#include "passes/oit/bidding.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool PricePass::wanted() const {
  return plan_.auctions();
}

void PricePass::declareWork(frame::PassDeclaration& d) const {
  declareBids(d, plan_);
  d.reads(Resource::CoveredSamples, Use::Storage);
  d.modifies(Resource::OitTotals, Use::Storage);
}

void PricePass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  gl::Defines defines = bidDefines(plan_);
  defines.emplace_back("ROUND", std::to_string(round_));
  program_ = programs.get({{"oit/price.comp"}, defines, {}});
}

void PricePass::run(frame::PassContext& context) {
  glUseProgram(program_);
  bindBids(context, plan_);
  context.bindStorage(SSBO_COVERED, Resource::CoveredSamples);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  context.dispatch({PRICE_THREADS, 1}, {LIST_GROUP, 1});
}

}  // namespace macula::passes
