// Lets one header be read by C++ and by GLSL. Only types whose std140 and std430 layouts equal the
// C++ ones are used: mat4 and vectors of four at multiples of 16 bytes, vectors of two at multiples
// of 8, scalars.
#ifndef MACULA_SHARED_CPP_GLSL_H
#define MACULA_SHARED_CPP_GLSL_H

#ifdef MACULA_GLSL
#define MACULA_SHARED_BEGIN
#define MACULA_SHARED_END
#define INOUT(type) inout type
#else
#include <cstdint>
#include <glm/glm.hpp>
#define MACULA_SHARED_BEGIN  \
  namespace macula::shader { \
  using glm::ivec2;          \
  using glm::ivec4;          \
  using glm::mat4;           \
  using glm::uvec4;          \
  using glm::vec2;           \
  using glm::vec4;           \
  using uint = std::uint32_t; /* NOLINT */
#define MACULA_SHARED_END }
#define INOUT(type) type&
#endif

#endif
