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
  glBlendFunc(GL_ONE, state.blend == Blend::Premultiplied ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE);
  glBlendEquation(state.blend == Blend::Max ? GL_MAX : GL_FUNC_ADD);
  if (state.blend == Blend::AddThenMax) {
    glBlendEquationi(1, GL_MAX);
    glBlendEquationi(3, GL_MAX);
  }
  enable(GL_FRAMEBUFFER_SRGB, state.encodeSrgb);
}

}  // namespace macula::gl
