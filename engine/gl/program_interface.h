// What a linked program uses, as the driver tells it (glGetProgramResource).
#pragma once

#include <array>
#include <cstddef>

#include "engine/gl/gl.h"

namespace macula::gl {

/// Properties of resource `index` of an interface (GL_UNIFORM, GL_SHADER_STORAGE_BLOCK, ...).
template <std::size_t N>
[[nodiscard]] std::array<GLint, N> propertiesOf(GLuint program, GLenum interface, GLuint index,
                                                const std::array<GLenum, N>& properties) {
  std::array<GLint, N> values{};
  glGetProgramResourceiv(program, interface, index, N, properties.data(), N, nullptr,
                         values.data());
  return values;
}

/// Resources of an interface that the program uses.
[[nodiscard]] inline GLuint resourceCount(GLuint program, GLenum interface) {
  GLint count = 0;
  glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
  return static_cast<GLuint>(count);
}

}  // namespace macula::gl
