// The registry on a CLI11 command line.
//
// Precedence: defaults, then TOML files (--config) in their order, then options and --set in the
// order in which they stand on the line. A setting that stands twice takes the last value.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "engine/settings/registry.h"

namespace macula::settings {

/// Adds one option for each setting (alias and dotted key), with unit, range and default in
/// --help under the setting's group, and `--config FILE.toml` and `--set KEY=VALUE`, both
/// repeatable. Parsing alone changes no setting: call applyOptions() afterwards.
/// @throws CLI::OptionAlreadyAdded where a setting's name is also an option of the command itself.
void addOptions(CLI::App& app, const Registry& registry);

/// After parsing: reads the TOML files and sets what the command line says.
/// @throws InputError for unknown settings, refused values, files that cannot be read, and rivals
///   that were both given (Registry::checkRivals()).
void applyOptions(const CLI::App& app, Registry& registry);

/// The check of an option that is a share of a whole, for CLI::Option::check(): a percentage is
/// refused with the number to write.
[[nodiscard]] CLI::Validator shareIn(const Range& range);

/// Parses a command line; callbacks of the command that was named run inside.
/// @param arguments without the program's name
/// @return false where help or a version was asked for and printed, so that nothing is left to do
/// @throws InputError in place of CLI::ParseError; an unknown option names the nearest known one.
bool parseCommandLine(CLI::App& root, std::vector<std::string> arguments);
bool parseCommandLine(CLI::App& root, int argc, const char* const* argv);

/// The one-line error for a failed parse.
/// @param root the app whose parse() threw
[[noreturn]] void failCommandLine(const CLI::App& root, const CLI::ParseError& error);

}  // namespace macula::settings
