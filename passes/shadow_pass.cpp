#include "passes/shadow_pass.h"

#include <glm/gtc/type_ptr.hpp>

#include "engine/gl/render_state.h"
#include "passes/resources.h"

namespace macula::passes {

void ShadowPass::declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const {
  d.scene();
  d.depth(kShadowMap, frame::Access::WritePersistent);
  d.size(kShadowMap, glm::ivec2(settings_.size));
}

bool ShadowPass::hasWork(const frame::FrameInputs& in) const {
  return needsShadowMap(in.facts);
}

std::string ShadowPass::reason(const frame::FrameInputs& in) const {
  if (!in.facts.shadowLight) return "no directional light casts shadows";
  if (in.facts.opaqueTriangles == 0) return "nothing opaque casts a shadow";
  return hasWork(in) ? "a directional light casts shadows; drawn once" : "nothing lit receives one";
}

void ShadowPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  drawn_ = false;
  const auto& runs = in.gpu->opaque().depthRuns;
  gl::Defines defines{{"SHADOW", "1"}};
  // One MASK run needs texture coordinates; then all runs of the list take the longer vertex stage.
  bool masked = false;
  for (const scene::DrawRun& run : runs) masked = masked || run.mask;
  defines.emplace_back(masked ? "UV_ONLY" : "POSITION_ONLY", "1");
  variants_.prepare(runs, "shadow.frag", defines, {}, programs);
}

void ShadowPass::execute(frame::PassContext& context) {
  if (drawn_) return;
  const scene::GpuScene& gpu = *context.inputs().gpu;
  const GLuint map = context.resources().texture(kShadowMap).id();
  glTextureParameteri(map, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTextureParameteri(map, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glTextureParameteri(map, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(map, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl::apply({.depthTest = true, .depthFunc = GL_LEQUAL, .depthWrite = true});
  constexpr GLfloat kFar = 1.0F;
  glClearBufferfv(GL_DEPTH, 0, &kFar);
  gpu.bindGeometry();
  for (const scene::DrawRun& run : gpu.opaque().depthRuns) {
    const GLuint program = variants_.programOf(run);
    glUseProgram(program);
    glUniformMatrix4fv(0, 1, GL_FALSE, glm::value_ptr(gpu.shadowViewProjection()));
    if (run.texturedMaterial != scene::kNone) gpu.bindMaterialTextures(run.texturedMaterial);
    gpu.draw(gpu.opaque(), run);
  }
  drawn_ = true;
}

}  // namespace macula::passes
