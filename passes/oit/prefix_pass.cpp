#include "passes/oit/prefix_pass.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool PrefixPass::wanted() const {
  return plan_.auctions();
}

void PrefixPass::declareWork(frame::PassDeclaration& d) const {
  d.modifies(Resource::StripSums, Use::Storage);
  d.modifies(Resource::OitTotals, Use::Storage);
}

void PrefixPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ =
      programs.get({{"oit/prefix.comp"}, rows_ ? gl::Defines{{"ROWS", "1"}} : gl::Defines{}, {}});
}

void PrefixPass::run(frame::PassContext& context) {
  glUseProgram(program_);
  context.bindStorage(SSBO_STRIP_SUMS, Resource::StripSums);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  if (rows_) {
    context.dispatch({1, 1}, {1, 1});
  } else {
    context.dispatch({plan_.size.y, 1}, {STRIP_GROUP, 1});
  }
}

}  // namespace macula::passes
