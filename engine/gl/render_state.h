// Fixed-function state of a draw, in one struct; apply() sets all of it.
#pragma once

#include <cstdint>

#include "engine/gl/gl.h"

namespace macula::gl {

enum class Blend : std::uint8_t {
  Off,
  Add,            ///< glBlendFunc(ONE, ONE)
  Premultiplied,  ///< glBlendFunc(ONE, ONE_MINUS_SRC_ALPHA)
  Max,            ///< glBlendEquation(MAX)
  AddThenMax,     ///< targets 0 and 2 add, targets 1 and 3 take the maximum
};

struct RenderState {
  bool depthTest = false;        ///< GL_DEPTH_TEST
  GLenum depthFunc = GL_GEQUAL;  ///< glDepthFunc; reversed depth: nearer is greater
  bool depthWrite = false;       ///< glDepthMask
  Blend blend = Blend::Off;      ///< GL_BLEND and glBlendFunc
  bool encodeSrgb = false;       ///< GL_FRAMEBUFFER_SRGB
};

void apply(const RenderState& state);

}  // namespace macula::gl
