#include "passes/opaque_shading.h"

#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

void declareShadingInputs(frame::PassDeclaration& d) {
  d.reads(Resource::ShadowMap, Use::Texture);
  d.reads(Resource::Depth, Use::Texture);
  d.reads(Resource::Normal, Use::Texture);
  d.reads(Resource::BaseColor, Use::Texture);
  d.reads(Resource::Surface, Use::Texture);
  d.reads(Resource::Emissive, Use::Texture);
}

void bindShadingInputs(frame::PassContext& context) {
  context.inputs().gpu->bindLights();
  if (needsShadowMap(context.inputs().facts)) {
    context.bindTexture(TEX_SHADOW_MAP, Resource::ShadowMap);
  }
  context.bindTexture(TEX_INPUT0, Resource::Depth);
  context.bindTexture(TEX_INPUT1, Resource::Normal);
  context.bindTexture(TEX_INPUT2, Resource::BaseColor);
  context.bindTexture(TEX_INPUT3, Resource::Surface);
  context.bindTexture(TEX_INPUT4, Resource::Emissive);
}

gl::Defines shadingDefines(const scene::SceneFacts& facts, ShadingWork work,
                           const LodParts& parts) {
  gl::Defines defines = lightingDefines(facts);
  if (facts.litOpaque) defines.emplace_back("LIT", "1");
  if (facts.veins) defines.emplace_back("VEINS", "1");
  if (facts.occlusion.any()) defines.emplace_back("OCCLUSION", "1");
  if (work == ShadingWork::All) return defines;
  const bool skipped = work == ShadingWork::AroundParts;
  if (parts.shadow == skipped) defines.emplace_back("SKIP_SHADOW", "1");
  if (parts.occlusion == skipped) defines.emplace_back("SKIP_OCCLUSION", "1");
  if (parts.noise == skipped) defines.emplace_back("SKIP_NOISE", "1");
  defines.emplace_back(work == ShadingWork::Parts ? "PARTS_OUT" : "PARTS_IN", "1");
  return defines;
}

}  // namespace macula::passes
