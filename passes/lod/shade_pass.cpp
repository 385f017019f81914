#include "passes/lod/shade_pass.h"

#include "passes/opaque_shading.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void LodShadePass::declareWork(frame::PassDeclaration& d) const {
  declareShadingInputs(d);
  if (plan_.foveated) {
    d.reads(Resource::LodTiles, Use::Storage);
    d.reads(Resource::LodTotals, Use::Indirect);
  }
  d.writes(Resource::LodSamples, Use::Image);
  d.writes(plan_.target(), Use::Image);
}

void LodShadePass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  const ShadingWork work = plan_.parts.shading ? ShadingWork::All : ShadingWork::Parts;
  gl::Defines defines = shadingDefines(in.facts, work, plan_.parts);
  pixels_ = programs.get({{"lighting.comp"}, defines, {}});
  if (plan_.demodulates) defines.emplace_back("DEMODULATE", "1");
  defines.emplace_back(plan_.foveated ? "AT_TILES" : "AT_GRID", "1");
  samples_ = programs.get({{"lighting.comp"}, defines, {}});
}

void LodShadePass::execute(frame::PassContext& context) {
  bindShadingInputs(context);
  glUseProgram(plan_.fullRate() ? pixels_ : samples_);
  context.bindImage(IMG_0, plan_.fullRate() ? plan_.target() : Resource::LodSamples, GL_WRITE_ONLY);
  for (int i = 0; i < plan_.load; ++i) {
    if (!plan_.foveated) {
      context.dispatch(plan_.fullRate() ? plan_.size : plan_.texels, kGroup);
      continue;
    }
    context.bindStorage(SSBO_LOD_TILES, Resource::LodTiles);
    context.bindStorage(SSBO_LOD_TOTALS, Resource::LodTotals);
    for (int level = 0; level < LOD_RATES; ++level) {
      glUniform1i(0, level);
      context.dispatchIndirect(Resource::LodTotals, dispatchOffset(level));
    }
  }
}

}  // namespace macula::passes
