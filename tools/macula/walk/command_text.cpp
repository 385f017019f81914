#include "walk/command_text.h"

#include <fmt/format.h>

namespace macula::tools {

std::string shellQuoted(std::string_view word) {
  constexpr std::string_view kSafe =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:=,+@%";
  if (!word.empty() && word.find_first_not_of(kSafe) == std::string_view::npos) {
    return std::string(word);
  }
  std::string quoted = "'";
  for (const char c : word) {
    // A quote cannot stand between quotes: end them, write it, begin anew.
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

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
