#include "passes/oit/count_colors_pass.h"

#include "engine/gl/render_state.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool CountColorsPass::wanted() const {
  return plan_.gathersColors();
}

void CountColorsPass::declareWork(frame::PassDeclaration& d) const {
  readsDepth(d, Use::DepthTarget);
  d.writes(Resource::FragmentCount, Use::ColorTarget);
  d.writes(Resource::DepthRange, Use::ColorTarget);
  d.writes(Resource::ColorSums, Use::ColorTarget);
  d.writes(Resource::NearestColor, Use::ColorTarget);
}

void CountColorsPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  gl::Defines defines{{"VERTEX_LIGHT", "1"}};
  if (in.facts.environment) defines.emplace_back("ENVIRONMENT", "1");  // its ambient light counts
  variants_.prepare(in.gpu->transparent().runs, "oit/count_colors.frag", defines, {}, programs);
}

void CountColorsPass::run(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  bindTargets(
      context,
      {Resource::FragmentCount, Resource::DepthRange, Resource::ColorSums, Resource::NearestColor},
      plan_.depth());
  gl::apply({.depthTest = true, .blend = gl::Blend::AddThenMax});
  constexpr GLfloat kNone[4]{};
  constexpr GLfloat kNoDepth[4]{-2.0F, -2.0F, 0.0F, 0.0F};  // less than any
  glClearBufferfv(GL_COLOR, 0, kNone);
  glClearBufferfv(GL_COLOR, 1, kNoDepth);
  glClearBufferfv(GL_COLOR, 2, kNone);
  glClearBufferfv(GL_COLOR, 3, kNone);
  gpu.bindLights();
  variants_.draw(gpu, gpu.transparent(), gpu.transparent().runs);
}

}  // namespace macula::passes
