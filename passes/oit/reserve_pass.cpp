#include "passes/oit/reserve_pass.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool ReservePass::wanted() const {
  return plan_.mapsImportance() && !plan_.auctions();
}

void ReservePass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::FragmentCount, Use::Texture);
  d.reads(Resource::Importance, Use::Image);
  d.modifies(Resource::OitTotals, Use::Storage);
}

void ReservePass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get({{"oit/reserve.comp"}, {}, {}});
}

void ReservePass::run(frame::PassContext& context) {
  glUseProgram(program_);
  context.bindTexture(TEX_INPUT0, Resource::FragmentCount);
  context.bindImage(IMG_0, Resource::Importance, GL_READ_ONLY);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  dispatchStrips(context, plan_.size);
}

}  // namespace macula::passes
