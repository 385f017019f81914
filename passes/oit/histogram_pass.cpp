#include "passes/oit/histogram_pass.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool HistogramPass::wanted() const {
  return plan_.method->allocation == Allocation::OneK && !plan_.auctions();
}

void HistogramPass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::FragmentCount, Use::Texture);
  d.modifies(Resource::CountBins, Use::Storage);
}

void HistogramPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get({{"oit/histogram.comp"}, {}, {}});
}

void HistogramPass::run(frame::PassContext& context) {
  glUseProgram(program_);
  context.bindTexture(TEX_INPUT0, Resource::FragmentCount);
  context.bindStorage(SSBO_STRIP_SUMS, Resource::CountBins);
  dispatchStrips(context, plan_.size);
}

}  // namespace macula::passes
