#include "passes/oit/one_k_pass.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool OneKPass::wanted() const {
  return plan_.method->allocation == Allocation::OneK && !plan_.auctions();
}

void OneKPass::declareWork(frame::PassDeclaration& d) const {
  d.consumes(Resource::CountBins, Use::Storage);
  d.modifies(Resource::OitTotals, Use::Storage);
}

void OneKPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get({{"oit/one_k.comp"}, {}, {}});
}

void OneKPass::run(frame::PassContext& context) {
  glUseProgram(program_);
  context.bindStorage(SSBO_STRIP_SUMS, Resource::CountBins);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  context.dispatch({1, 1}, {1, 1});
}

}  // namespace macula::passes
