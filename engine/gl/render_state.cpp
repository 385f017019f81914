#include "engine/gl/render_state.h"

namespace macula::gl {
namespace {

void enable(GLenum capability, bool on) {
  on ? glEnable(capability) : glDisable(capability);
}

}  // namespace

void apply(const RenderState& state) {
  enable(GL_DEPTH_TEST, state.depthTest || state.depthWrite);
  glDepthFunc(state.depthTest ? state.depthFunc : GL_ALWAYS);
  glDepthMask(state.depthWrite ? GL_TRUE : GL_FALSE);
  enable(GL_BLEND, state.blend != Blend::Off);
  glBlendFunc(GL_ONE, state.blend == Blend::Add ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
  glBlendEquation(state.blend == Blend::Max ? GL_MAX : GL_FUNC_ADD);
  enable(GL_FRAMEBUFFER_SRGB, state.encodeSrgb);
}

}  // namespace macula::gl
