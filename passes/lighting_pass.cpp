#include "passes/lighting_pass.h"

#include "passes/scene_draw.h"
#include "shared/bindings.h"
#include "shared/dispatch.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

namespace {

constexpr glm::ivec2 kGroup{FULLSCREEN_GROUP};

}  // namespace

void LightingPass::declare(frame::PassDeclaration& d) const {
  d.reads(Resource::ShadowMap, Use::Texture);
  d.reads(Resource::Depth, Use::Texture);
  d.reads(Resource::Normal, Use::Texture);
  d.reads(Resource::BaseColor, Use::Texture);
  d.reads(Resource::Surface, Use::Texture);
  d.reads(Resource::Emissive, Use::Texture);
  d.writes(Resource::HdrColor, Use::Image);
}

bool LightingPass::hasWork(const frame::FrameInputs& in) const {
  return in.facts.opaqueTriangles > 0 || in.facts.environment;
}

std::string LightingPass::reason(const frame::FrameInputs& in) const {
  if (in.facts.litOpaque) return "opaque surfaces are lit";
  if (in.facts.opaqueTriangles > 0)
    return "unlit opaque surfaces are copied; no light is evaluated";
  return in.facts.environment ? "the environment is the background"
                              : "nothing opaque, no environment";
}

void LightingPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  gl::Defines defines = lightingDefines(in.facts);
  if (in.facts.litOpaque) defines.emplace_back("LIT", "1");
  shadows_ = needsShadowMap(in.facts);
  program_ = programs.get({{"lighting.comp"}, defines, {}});
}

void LightingPass::execute(frame::PassContext& context) {
  glUseProgram(program_);
  context.inputs().gpu->bindLights();
  if (shadows_) context.bindTexture(TEX_SHADOW_MAP, Resource::ShadowMap);
  context.bindTexture(TEX_INPUT0, Resource::Depth);
  context.bindTexture(TEX_INPUT1, Resource::Normal);
  context.bindTexture(TEX_INPUT2, Resource::BaseColor);
  context.bindTexture(TEX_INPUT3, Resource::Surface);
  context.bindTexture(TEX_INPUT4, Resource::Emissive);
  context.bindImage(IMG_0, Resource::HdrColor, GL_WRITE_ONLY);
  context.dispatch(context.inputs().displaySize, kGroup);
}

}  // namespace macula::passes
