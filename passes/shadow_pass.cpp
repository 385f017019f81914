#include "passes/shadow_pass.h"

#include "engine/gl/render_state.h"
#include "passes/light_defines.h"
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
  variants_.prepare(in.gpu->opaque().depthRuns, "shadow.frag",
                    {{"SHADOW", "1"}, {"POSITION_ONLY", "1"}}, {}, programs);
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
  variants_.draw(gpu, gpu.opaque(), gpu.opaque().depthRuns, &gpu.shadowViewProjection());
  drawn_ = true;
}

}  // namespace macula::passes
