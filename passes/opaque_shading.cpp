#include "passes/opaque_shading.h"

#include "passes/resources.h"
#include "shared/bindings.h"

namespace macula::passes {

void declareShadingInputs(frame::PassDeclaration& d, const scene::SceneFacts& facts,
                          ShadingWork work, const LodParts& parts, bool samples) {
  if (facts.opaqueTriangles == 0) return;  // the background needs no G-buffer
  const bool lights = work != ShadingWork::Parts;
  const bool shadow = lights ? work == ShadingWork::All || !parts.shadow : parts.shadow;
  const bool normal = lights ? facts.litOpaque : parts.shadow || parts.occlusion;
  if (facts.litOpaque && shadow && needsShadowMap(facts)) d.texture(TEX_SHADOW_MAP, kShadowMap);
  d.texture(TEX_INPUT0, kDepth);
  if (normal || samples) d.texture(TEX_INPUT1, kNormal);
  if (lights) d.texture(TEX_INPUT2, kBaseColor);
  d.texture(TEX_INPUT3, kSurface);
  if (lights) d.texture(TEX_INPUT4, kEmissive);
}

gl::Defines shadingDefines(const frame::FrameInputs& in, ShadingWork work, const LodParts& parts) {
  const scene::SceneFacts& facts = in.facts;
  gl::Defines defines = lightingDefines(in);
  if (facts.opaqueTriangles == 0) defines.emplace_back("NOTHING_OPAQUE", "1");
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
