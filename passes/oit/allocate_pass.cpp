#include "passes/oit/allocate_pass.h"

#include "passes/oit/hand_out.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool AllocatePass::wanted() const {
  return plan_.method->hasRanges() && !plan_.auctions();
}

void AllocatePass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::FragmentCount, Use::Texture);
  if (plan_.mapsImportance()) d.reads(Resource::Importance, Use::Image);
  declareHandOut(d, plan_);
  d.modifies(Resource::OitTotals, Use::Storage);
}

void AllocatePass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  gl::Defines defines = handOutDefines(plan_);
  const bool exact = plan_.method->allocation == Allocation::ExactCount;
  const bool oneK = plan_.method->allocation == Allocation::OneK;
  defines.emplace_back(exact  ? "ALLOCATION_EXACT"
                       : oneK ? "ALLOCATION_ONE_K"
                              : "ALLOCATION_IMPORTANCE",
                       "1");
  program_ = programs.get({{"oit/allocate.comp"}, defines, {}});
}

void AllocatePass::run(frame::PassContext& context) {
  glUseProgram(program_);
  context.bindTexture(TEX_INPUT0, Resource::FragmentCount);
  if (plan_.mapsImportance()) context.bindImage(IMG_2, Resource::Importance, GL_READ_ONLY);
  bindHandOut(context, plan_);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  dispatchStrips(context, plan_.size);
}

}  // namespace macula::passes
