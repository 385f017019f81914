#include "passes/oit/network_importance_pass.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool NetworkImportancePass::wanted() const {
  return plan_.mapsImportance() && plan_.usesNetwork();
}

void NetworkImportancePass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::FragmentCount, Use::Texture);
  d.reads(Resource::NetworkOutput, Use::Texture);
  d.modifies(Resource::Importance, Use::Image);  // 0 where nothing is transparent
  if (plan_.factorMaps) d.modifies(Resource::ImportanceFactors, Use::Image);
  d.modifies(Resource::OitTotals, Use::Storage);
}

void NetworkImportancePass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  gl::Defines defines{{"NETWORK_TILE", std::to_string(plan_.importance.networkTile)}};
  if (plan_.factorMaps) defines.emplace_back("FACTORS", "1");
  program_ = programs.get({{"oit/network_importance.comp"}, defines, {}});
}

void NetworkImportancePass::run(frame::PassContext& context) {
  glUseProgram(program_);
  context.bindTexture(TEX_INPUT0, Resource::FragmentCount);
  context.bindTexture(TEX_INPUT2, Resource::NetworkOutput);
  context.bindImage(IMG_0, Resource::Importance, GL_WRITE_ONLY);
  if (plan_.factorMaps) context.bindImage(IMG_1, Resource::ImportanceFactors, GL_WRITE_ONLY);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  dispatchStrips(context, plan_.size);
}

}  // namespace macula::passes
