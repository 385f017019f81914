#include "passes/oit/importance_pass.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool ImportancePass::wanted() const {
  return plan_.mapsImportance() && !plan_.usesNetwork();
}

void ImportancePass::declareWork(frame::PassDeclaration& d) const {
  d.reads(plan_.countResource(), Use::Texture);
  d.carries(Resource::FrontNormal, Use::Image);
  d.modifies(Resource::Importance, Use::Image);  // 0 where nothing is transparent
  if (plan_.factorMaps) d.modifies(Resource::ImportanceFactors, Use::Image);
  d.modifies(Resource::OitTotals, Use::Storage);
}

void ImportancePass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  gl::Defines defines;
  if (plan_.factorMaps) defines.emplace_back("FACTORS", "1");
  program_ = programs.get({{"oit/importance.comp"}, defines, {}});
}

void ImportancePass::run(frame::PassContext& context) {
  glUseProgram(program_);
  const ImportanceSettings& s = plan_.importance;
  glUniform4f(0, static_cast<float>(s.rangeBias), static_cast<float>(s.periphery),
              static_cast<float>(s.noise), plan_.layerLimit);
  glUniform1ui(1, plan_.seed + (s.noisePerFrame ? context.inputs().frameIndex : 0U));
  context.bindTexture(TEX_INPUT0, plan_.countResource());
  context.bindImage(IMG_2, Resource::FrontNormal, GL_READ_WRITE);
  context.bindImage(IMG_0, Resource::Importance, GL_WRITE_ONLY);
  if (plan_.factorMaps) context.bindImage(IMG_1, Resource::ImportanceFactors, GL_WRITE_ONLY);
  context.bindStorage(SSBO_OIT_TOTALS, Resource::OitTotals);
  dispatchStrips(context, plan_.size);
}

}  // namespace macula::passes
