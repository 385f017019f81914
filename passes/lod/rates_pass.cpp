#include "passes/lod/rates_pass.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void LodRatesPass::declareWork(frame::PassDeclaration& d) const {
  if (plan_.foveated) {
    d.writes(Resource::ShadingRate, Use::Image);
    d.writes(Resource::LodTiles, Use::Storage);
  }
  d.writes(Resource::LodTotals, Use::Storage);
}

void LodRatesPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  if (plan_.foveated) program_ = programs.get({{"lod/rates.comp"}, {}, {}});
}

void LodRatesPass::execute(frame::PassContext& context) {
  shader::LodTotals zero{};
  for (glm::uvec4& dispatch : zero.dispatches) dispatch = {0U, 1U, 1U, 0U};
  context.resources().upload(Resource::LodTotals, &zero, sizeof(zero));
  if (!plan_.foveated) return;
  glUseProgram(program_);
  context.bindImage(IMG_0, Resource::ShadingRate, GL_WRITE_ONLY);
  context.bindStorage(SSBO_LOD_TILES, Resource::LodTiles);
  context.bindStorage(SSBO_LOD_TOTALS, Resource::LodTotals);
  context.dispatch(plan_.tiles, kGroup);
}

}  // namespace macula::passes
