#include "passes/lod/reconstruct_pass.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void LodReconstructPass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::LodSamples, Use::Texture);
  d.reads(Resource::Depth, Use::Texture);
  d.reads(Resource::Normal, Use::Texture);
  if (plan_.demodulates) {
    d.reads(Resource::BaseColor, Use::Texture);
    d.reads(Resource::Emissive, Use::Texture);
    d.reads(Resource::Surface, Use::Texture);
  }
  if (plan_.foveated) d.reads(Resource::ShadingRate, Use::Texture);
  if (plan_.shadesHoles()) {
    d.modifies(Resource::LodTotals, Use::Storage);
    d.writes(Resource::LodHoles, Use::Storage);
  }
  d.modifies(plan_.target(), Use::Image);  // left alone where r is 1
}

void LodReconstructPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  gl::Defines defines;
  if (plan_.reconstruction == Reconstruction::Bilinear) defines.emplace_back("BILINEAR", "1");
  if (plan_.reconstruction == Reconstruction::Yang2008) defines.emplace_back("YANG2008", "1");
  if (!plan_.parts.shading) defines.emplace_back("PARTS", "1");
  if (plan_.foveated) defines.emplace_back("FOVEATED", "1");
  if (plan_.demodulates) {
    defines.emplace_back("DEMODULATE", "1");
    if (in.facts.unlitOpaque) defines.emplace_back("UNLIT", "1");
  }
  if (plan_.shadesHoles()) defines.emplace_back("SHADE_HOLES", "1");
  program_ = programs.get({{"lod/reconstruct.comp"}, defines, {}});
}

void LodReconstructPass::execute(frame::PassContext& context) {
  if (plan_.fullRate()) return;
  glUseProgram(program_);
  if (plan_.reconstruction == Reconstruction::Yang2008) {
    glUniform2f(0, plan_.sigma.x, plan_.sigma.y);
  }
  context.bindTexture(TEX_INPUT0, Resource::LodSamples);
  context.bindTexture(TEX_INPUT1, Resource::Depth);
  context.bindTexture(TEX_INPUT2, Resource::Normal);
  if (plan_.foveated) context.bindTexture(TEX_INPUT3, Resource::ShadingRate);
  if (plan_.demodulates) {
    context.bindTexture(TEX_INPUT4, Resource::BaseColor);
    context.bindTexture(TEX_INPUT5, Resource::Emissive);
    context.bindTexture(TEX_INPUT6, Resource::Surface);
  }
  context.bindImage(IMG_0, plan_.target(), GL_WRITE_ONLY);
  if (plan_.shadesHoles()) {
    context.bindStorage(SSBO_LOD_TOTALS, Resource::LodTotals);
    context.bindStorage(SSBO_LOD_HOLES, Resource::LodHoles);
  }
  context.dispatch(plan_.size, kGroup);
}

}  // namespace macula::passes
