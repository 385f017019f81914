// Shader text: includes, defines and the version line. No GL, so that tools can use it too.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace macula::gl {

/// NAME or NAME=VALUE pairs, in the order in which they are written into the shader.
using Defines = std::vector<std::pair<std::string, std::string>>;

/// Puts a shader together.
/// @param root folder of the shaders; `#include "lib/x.glsl"` is looked up in it, once per file
/// @param file entry point, relative to root; its suffix names the stage (.vert .frag .comp)
/// @param defines written after the version line
/// @param extensions names for `#extension NAME : require`
/// @throws InputError naming file and line of an include that is missing.
[[nodiscard]] std::string assembleShader(const std::filesystem::path& root, std::string_view file,
                                         const Defines& defines,
                                         const std::vector<std::string>& extensions = {});

/// A constant of the shading language that reads back as the same float. @param value finite
[[nodiscard]] std::string literal(float value);

}  // namespace macula::gl
