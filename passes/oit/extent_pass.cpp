#include "passes/oit/extent_pass.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool ExtentPass::wanted() const {
  return plan_.gathersColors();
}

void ExtentPass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::FragmentCount, Use::Texture);
  d.reads(Resource::DepthRange, Use::Texture);
  d.modifies(Resource::OitTotals, Use::Storage);
}

void ExtentPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get({{"oit/extent.comp"}, {}, {}});
}

void ExtentPass::run(frame::PassContext& context) {
  glUseProgram(program_);
  context.bindTexture(TEX_INPUT0, Resource::FragmentCount);
  context.bindTexture(TEX_INPUT1, Resource::DepthRange);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  dispatchStrips(context, plan_.size);
}

}  // namespace macula::passes
