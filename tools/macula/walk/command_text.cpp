#include "walk/command_text.h"

#include <fmt/format.h>

#include "engine/core/shell.h"

namespace macula::tools {

std::string walkCommandLine(const settings::Registry& registry, const std::string& scene,
                            glm::ivec2 size, const std::string& gaze) {
  // A file whose name begins like an option is named by its folder.
  const std::string place = scene.starts_with('-') ? "./" + scene : scene;
  std::string text = fmt::format("macula walk {} --size {}x{}", shellQuoted(place), size.x, size.y);
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
