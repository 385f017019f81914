#include "passes/lighting_pass.h"

#include "passes/lod/resources.h"
#include "passes/resources.h"
#include "shared/bindings.h"
#include "shared/dispatch.h"

namespace macula::passes {

namespace {

constexpr glm::ivec2 kGroup{FULLSCREEN_GROUP};

}  // namespace

void LightingPass::declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const {
  declareShadingInputs(d, in.facts, work(), lod_.parts, false);
  if (lod_.wanted) d.texture(TEX_INPUT5, kShadingParts);
  d.image(IMG_0, kHdrColor, frame::Access::Write);
}

bool LightingPass::hasWork(const frame::FrameInputs& in) const {
  return !atReducedRate() && (in.facts.opaqueTriangles > 0 || in.facts.environment);
}

std::string LightingPass::reason(const frame::FrameInputs& in) const {
  if (atReducedRate()) return "the level of detail shades";
  if (in.facts.litOpaque) return "opaque surfaces are lit";
  if (in.facts.opaqueTriangles > 0)
    return "unlit opaque surfaces are copied; no light is evaluated";
  return in.facts.environment ? "the environment is the background"
                              : "nothing opaque, no environment";
}

void LightingPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  program_ = programs.get({{"lighting.comp"}, shadingDefines(in, work(), lod_.parts), {}});
}

void LightingPass::execute(frame::PassContext& context) {
  glUseProgram(program_);
  // A load is on what a controller can compute at 1/r; without parts that is this pass.
  const int times = lod_.wanted ? 1 : lod_.load;
  for (int i = 0; i < times; ++i) {
    if (i > 0) context.beginStep(0);  // each writes the whole image
    context.dispatch(context.inputs().displaySize, kGroup);
  }
}

}  // namespace macula::passes
