#include "walk/command_text.h"

#include <fmt/format.h>

#include "engine/core/shell.h"

namespace macula::tools {

std::string asArgument(const std::string& file) {
  return shellQuoted(file.starts_with('-') ? "./" + file : file);
}

std::string walkCommandLine(const settings::Registry& registry, const std::string& scene,
                            glm::ivec2 size, const std::string& gaze) {
  std::string text = fmt::format("macula walk {} --size {}x{}", asArgument(scene), size.x, size.y);
  if (gaze != "mouse") text += " --gaze " + shellQuoted(gaze);
  for (const settings::Entry& entry : registry.entries()) {
    if (entry.isDefault()) continue;
    const std::string value = settings::formatValue(entry.get());
    // A value that begins like an option is tied to its own.
    const char* tie = value.starts_with('-') ? "=" : " ";
    text += " " + entry.option() + tie + shellQuoted(value);
  }
  return text;
}

}  // namespace macula::tools
