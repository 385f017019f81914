// Compares what shaders use with the binding table of their pass.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/frame/binding.h"

namespace macula::frame {

/// What one program binds: an active sampler, image, storage block or fragment output.
struct ShaderBinding {
  BindPoint point = BindPoint::Texture;
  std::uint32_t unit = 0;
  GLenum type = 0;        ///< of a sampler, image or output, as GL_FLOAT_VEC4
  std::size_t bytes = 0;  ///< of a storage block, its unsized array counted as one element
  std::string name;       ///< in the shader
};

/// What a program binds, asked from the driver. Left out are the scene's own bindings (instances,
/// materials and their textures, environment), which GpuScene binds, and uniform blocks.
[[nodiscard]] std::vector<ShaderBinding> bindingsOf(GLuint program);

/// Differences between the table of a pass and what its programs bind, one line each. The steps of
/// a pass are taken together, since which step runs which program is the pass's own affair: every
/// binding of a program needs a row of its kind, and every row that is bound to a unit needs a
/// program that uses it. No GL.
[[nodiscard]] std::vector<std::string> compareBindings(
    std::string_view pass, const PassDeclaration& table,
    std::span<const std::vector<ShaderBinding>> programs);

/// How much was compared.
struct BindingCount {
  std::size_t programs = 0;
  std::size_t rows = 0;
};

}  // namespace macula::frame
