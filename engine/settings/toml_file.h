// Settings from TOML 1.0 (toml++).
#pragma once

#include <filesystem>
#include <string_view>

#include "engine/settings/registry.h"
#include "engine/settings/toml.h"

namespace macula::settings {

/// Parses TOML text. @param name what to call the text in messages, usually its path
/// @throws InputError "name:line:column: reason" for anything malformed, and for text that nests
/// deeper or is larger than any settings file (1 MiB, 256 dots a line, 16 values within values).
[[nodiscard]] toml::table parseToml(std::string_view text, std::string_view name);

/// Sets every value of a table, to any depth: `[oit] kAve = 4`, `oit.kAve = 4` and the alias
/// `k-ave = 4` mean the same. Numbers and text must have their TOML type; a boolean may also be 1,
/// 0 or a word of the command line in quotes, "on"; a colour is "R,G,B" or [R, G, B]. A path is
/// taken as written, not relative to the file.
/// @throws InputError "name:line: ..." for an unknown setting, a refused value, or a setting that
/// stands twice; what came before it in the table has then been set.
void applyTable(Registry& registry, const toml::table& table, std::string_view name);

/// parseToml() and applyTable().
void applyTomlText(Registry& registry, std::string_view text, std::string_view name);
/// The same for a file.
void applyTomlFile(Registry& registry, const std::filesystem::path& path);

}  // namespace macula::settings
