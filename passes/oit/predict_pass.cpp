#include "passes/oit/predict_pass.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool PredictPass::wanted() const {
  return plan_.predictsCounts();
}

void PredictPass::declareWork(frame::PassDeclaration& d) const {
  readsDepth(d, Use::Texture);
  d.readsHistory(Resource::FragmentCount, Use::Texture);
  d.readsHistory(Resource::FragmentRange, Use::Texture);
  d.readsHistory(Resource::FragmentFill, Use::Texture);
  d.readsHistory(Resource::FragmentKeys, Use::Storage);
  d.writes(Resource::PredictedCount, Use::ImageOrTarget);
}

void PredictPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  count_.prepare(in, programs);
  program_ = programs.get({{"oit/predict.comp"}, {}, {}});
}

void PredictPass::run(frame::PassContext& context) {
  if (!plan_.historyValid) {
    bindTargets(context, {Resource::PredictedCount}, plan_.depth());
    count_.draw(*context.inputs().gpu);
    return;
  }
  glUseProgram(program_);
  context.bindTexture(TEX_INPUT0, Resource::FragmentCount);
  context.bindTexture(TEX_INPUT1, Resource::FragmentRange);
  context.bindTexture(TEX_INPUT2, Resource::FragmentFill);
  context.bindTexture(TEX_INPUT3, plan_.depth());
  context.bindStorage(SSBO_FRAGMENT_KEYS, Resource::FragmentKeys);
  context.bindImage(IMG_0, Resource::PredictedCount, GL_WRITE_ONLY);
  context.dispatch(plan_.size, kFullScreenGroup);
}

}  // namespace macula::passes
