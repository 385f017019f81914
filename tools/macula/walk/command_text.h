// The command line that begins a walk as it is now.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "engine/settings/registry.h"

namespace macula::tools {

/// A file as an argument in a shell: one whose name begins like an option is named by its folder.
[[nodiscard]] std::string asArgument(const std::string& file);

/// `macula walk SCENE --size WxH --gaze SPEC` and every setting that is not its default.
/// @param gaze as --gaze takes it
[[nodiscard]] std::string walkCommandLine(const settings::Registry& registry,
                                          const std::string& scene, glm::ivec2 size,
                                          const std::string& gaze);

}  // namespace macula::tools
