#include "passes/tonemap_pass.h"

#include <cmath>

#include "passes/resources.h"
#include "shared/bindings.h"
#include "shared/dispatch.h"

namespace macula::passes {

namespace {

constexpr glm::ivec2 kGroup{FULLSCREEN_GROUP};

/// TONEMAP of shaders/lib/tonemap.glsl.
std::string curveNumber(const std::string& curve) {
  if (curve == "neutral") return "1";
  return curve == "aces" ? "2" : "0";
}

}  // namespace

void TonemapPass::declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const {
  d.texture(TEX_INPUT0, kHdrColor);
  d.image(IMG_0, kDisplayColor, frame::Access::Write);
  if (settings_.linearOut) d.image(IMG_1, kLinearColor, frame::Access::Write);
}

bool TonemapPass::hasWork(const frame::FrameInputs& /*in*/) const {
  return true;
}

std::string TonemapPass::reason(const frame::FrameInputs& /*in*/) const {
  return "every frame is shown";
}

void TonemapPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  gl::Defines defines{{"TONEMAP", curveNumber(settings_.curve)},
                      {"SSAA", std::to_string(settings_.ssaa)}};
  if (settings_.linearOut) defines.emplace_back("LINEAR_OUT", "1");
  program_ = programs.get({{"tonemap.comp"}, defines, {}});
}

void TonemapPass::execute(frame::PassContext& context) {
  glUseProgram(program_);
  glUniform1f(0, static_cast<float>(std::exp2(settings_.exposure)));
  context.dispatch(context.inputs().outputSize, kGroup);
}

}  // namespace macula::passes
