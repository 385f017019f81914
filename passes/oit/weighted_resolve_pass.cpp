#include "passes/oit/weighted_resolve_pass.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool WeightedResolvePass::wanted() const {
  return plan_.method->insertion == Insertion::Weighted;
}

void WeightedResolvePass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::WeightedColors, Use::Texture);
  d.reads(Resource::TailSums, Use::Texture);
  modifiesColor(d, Use::Image);
}

void WeightedResolvePass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get({{"oit/weighted_resolve.comp"}, {}, {}});
}

void WeightedResolvePass::run(frame::PassContext& context) {
  glUseProgram(program_);
  context.bindTexture(TEX_INPUT0, Resource::WeightedColors);
  context.bindTexture(TEX_INPUT1, Resource::TailSums);
  context.bindImage(IMG_0, plan_.color(), GL_READ_WRITE);
  context.dispatch(plan_.size, kFullScreenGroup);
}

}  // namespace macula::passes
