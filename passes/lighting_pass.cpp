#include "passes/lighting_pass.h"

#include "passes/opaque_shading.h"
#include "shared/bindings.h"
#include "shared/dispatch.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

namespace {

constexpr glm::ivec2 kGroup{FULLSCREEN_GROUP};

}  // namespace

void LightingPass::declare(frame::PassDeclaration& d) const {
  if (resized()) return;
  declareShadingInputs(d);
  if (lod_.wanted) d.reads(Resource::ShadingParts, Use::Texture);
  d.writes(Resource::HdrColor, Use::Image);
}

bool LightingPass::hasWork(const frame::FrameInputs& in) const {
  return !resized() && (in.facts.opaqueTriangles > 0 || in.facts.environment);
}

std::string LightingPass::reason(const frame::FrameInputs& in) const {
  if (resized()) return "the level of detail shades";
  if (in.facts.litOpaque) return "opaque surfaces are lit";
  if (in.facts.opaqueTriangles > 0)
    return "unlit opaque surfaces are copied; no light is evaluated";
  return in.facts.environment ? "the environment is the background"
                              : "nothing opaque, no environment";
}

void LightingPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  const ShadingWork work = lod_.wanted ? ShadingWork::AroundParts : ShadingWork::All;
  program_ = programs.get({{"lighting.comp"}, shadingDefines(in.facts, work, lod_.parts), {}});
}

void LightingPass::execute(frame::PassContext& context) {
  glUseProgram(program_);
  bindShadingInputs(context);
  if (lod_.wanted) context.bindTexture(TEX_INPUT5, Resource::ShadingParts);
  context.bindImage(IMG_0, Resource::HdrColor, GL_WRITE_ONLY);
  // A load is on what a controller can resize; without parts that is this pass.
  const int times = lod_.wanted ? 1 : lod_.load;
  for (int i = 0; i < times; ++i) context.dispatch(context.inputs().displaySize, kGroup);
}

}  // namespace macula::passes
