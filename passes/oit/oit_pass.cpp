#include "passes/oit/oit_pass.h"

#include <fmt/format.h>

#include "engine/core/plural.h"
#include "passes/light_defines.h"
#include "shared/bindings.h"
#include "shared/oit_constants.h"
#include "shared/oit_totals.h"

namespace macula::passes {

using frame::Access;

bool OitPass::hasWork(const frame::FrameInputs& in) const {
  return in.facts.transparentTriangles > 0 && wanted();
}

std::string OitPass::reason(const frame::FrameInputs& in) const {
  if (in.facts.transparentTriangles == 0) return "nothing transparent";
  if (!wanted()) return fmt::format("{} does not use it", plan_.method->id);
  return fmt::format("{} by {}", counted(in.facts.transparentTriangles, "transparent triangle"),
                     plan_.method->id);
}

void OitPass::execute(frame::PassContext& context) {
  if (plan_.reduced()) context.bindConstants(frame::Raster::Reduced);
  run(context);
  if (plan_.reduced()) context.bindConstants(frame::Raster::Image);
}

void OitPass::depthTexture(frame::PassDeclaration& d, std::uint32_t unit, bool active) const {
  d.texture(unit, kDepth).when(active && !plan_.reduced());
  if (plan_.resizable) d.texture(unit, kReducedDepth).when(active && plan_.reduced());
}

void OitPass::depthTarget(frame::PassDeclaration& d, bool active) const {
  d.viewport(plan_.size);
  d.depth(kDepth).when(active && !plan_.reduced());
  if (plan_.resizable) d.depth(kReducedDepth).when(active && plan_.reduced());
}

void OitPass::testedDepthTexture(frame::PassDeclaration& d, std::uint32_t unit) const {
  plan_.culls() ? void(d.texture(unit, kCullDepth)) : depthTexture(d, unit);
}

void OitPass::testedDepthTarget(frame::PassDeclaration& d) const {
  if (!plan_.culls()) return depthTarget(d);
  d.viewport(plan_.size);
  d.depth(kCullDepth);
}

void OitPass::colorImage(frame::PassDeclaration& d, std::uint32_t unit) const {
  d.image(unit, kHdrColor, Access::ReadWrite).when(!plan_.reduced());
  if (plan_.resizable) d.image(unit, kReducedColor, Access::ReadWrite).when(plan_.reduced());
}

void OitPass::colorTarget(frame::PassDeclaration& d, std::uint32_t location) const {
  d.color(location, kHdrColor, Access::ReadWrite).when(!plan_.reduced());
  if (plan_.resizable) d.color(location, kReducedColor, Access::ReadWrite).when(plan_.reduced());
}

void OitPass::shadowMap(frame::PassDeclaration& d, const frame::FrameInputs& in) {
  if (needsShadowMap(in.facts) && in.facts.litTransparent) d.texture(TEX_SHADOW_MAP, kShadowMap);
}

void OitComputePass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  program_ = programs.get(program());
}

void OitComputePass::dispatch(const frame::PassContext& context) {
  dispatchTiles(context, plan_.size);
}

void OitComputePass::run(frame::PassContext& context) {
  glUseProgram(program_);
  dispatch(context);
}

void totalsRow(frame::PassDeclaration& d, Access access) {
  d.storage(SSBO_OIT_TOTALS, kOitTotals, access);
  if (frame::writes(access)) d.bytes(kOitTotals, sizeof(shader::OitTotals));
}

void keysRow(frame::PassDeclaration& d, const OitPlan& plan, Access access) {
  constexpr std::size_t kKeyBytes = 8;  // of a packed fragment, all of it
  d.storage(SSBO_FRAGMENT_KEYS, kFragmentKeys, access);
  if (frame::writes(access)) d.bytes(kFragmentKeys, plan.poolSlots * kKeyBytes);
}

void colorsRow(frame::PassDeclaration& d, const OitPlan& plan, Access access) {
  constexpr std::size_t kColorBytes = 8;
  if (plan.packed()) return;
  d.storage(SSBO_FRAGMENT_COLORS, kFragmentColors, access);
  if (frame::writes(access)) d.bytes(kFragmentColors, plan.poolSlots * kColorBytes);
}

void linksRow(frame::PassDeclaration& d, const OitPlan& plan, Access access) {
  if (!plan.method->insertion.links) return;
  d.storage(SSBO_FRAGMENT_LINKS, kFragmentLinks, access);
  if (frame::writes(access)) d.bytes(kFragmentLinks, plan.poolSlots * kLinkBytes);
}

void slotRangeRows(frame::PassDeclaration& d, const OitPlan& plan) {
  // Only covered pixels are written. The frame clears the others, as a whole, which is cheaper than
  // a store in each of them.
  d.image(IMG_0, kFragmentRange, Access::ReadWrite);
  if (!plan.emptiesTails()) return;
  keysRow(d, plan, Access::Write);
  colorsRow(d, plan, Access::Write);
}

gl::Defines slotRangeDefines(const OitPlan& plan) {
  gl::Defines defines;
  if (plan.packed()) defines.emplace_back("PACKED", "1");
  if (plan.emptiesTails()) defines.emplace_back("TAIL_IN_SLOT", "1");
  return defines;
}

void dispatchTiles(const frame::PassContext& context, glm::ivec2 size) {
  context.dispatch(size, {TILE_WIDTH, TILE_HEIGHT});
}

}  // namespace macula::passes
