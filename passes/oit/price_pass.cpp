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
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  const int stride = priceStride(plan_.size);
  const glm::ivec2 samples = (plan_.size + stride - 1) / stride;
  context.dispatch({(samples.x + STRIP - 1) / STRIP, samples.y}, {STRIP_GROUP, 1});
}

}  // namespace macula::passes
