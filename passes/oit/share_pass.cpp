#include "passes/oit/share_pass.h"

#include "passes/oit/hand_out.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool SharePass::wanted() const {
  return plan_.auctions();
}

void SharePass::declareWork(frame::PassDeclaration& d) const {
  d.reads(plan_.countResource(), Use::Texture);
  d.consumes(Resource::SlotBids, Use::Image);
  d.consumes(Resource::StripSums, Use::Storage);
  d.reads(Resource::OitTotals, Use::Storage);
  declareHandOut(d, plan_);
}

void SharePass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get({{"oit/share.comp"}, handOutDefines(plan_), {}});
}

void SharePass::run(frame::PassContext& context) {
  glUseProgram(program_);
  context.bindTexture(TEX_INPUT0, plan_.countResource());
  context.bindImage(IMG_2, Resource::SlotBids, GL_READ_ONLY);
  bindHandOut(context, plan_);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  context.bindStorage(SSBO_STRIP_SUMS, Resource::StripSums);
  dispatchStrips(context, plan_.size);
}

}  // namespace macula::passes
