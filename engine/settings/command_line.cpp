#include "engine/settings/command_line.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/nearest.h"
#include "engine/settings/toml_file.h"

namespace macula::settings {
namespace {

constexpr const char* kConfig = "--config";
constexpr const char* kSet = "--set";

/// Longer arguments are cut before they are compared and shown.
constexpr std::size_t kShownCharacters = 80;

/// Above this a list of choices moves from the option's type to its description.
constexpr std::size_t kTypeCharacters = 24;

std::string typeName(const Entry& entry) {
  if (!entry.choices().empty()) {
    std::string words;
    for (const std::string& choice : entry.choices()) words += (words.empty() ? "" : "|") + choice;
    return words.size() <= kTypeCharacters ? words : "CHOICE";
  }
  switch (entry.type()) {
    case Type::Bool:
      return "on|off";
    case Type::Int:
      return "INTEGER";
    case Type::Real:
      return "NUMBER";
    case Type::Colour:
      return "R,G,B";
    case Type::Path:
      return "PATH";
    case Type::Choice:
    case Type::Text:
      break;
  }
  return "TEXT";
}

/// "Average layers of a pixel (fragments/pixel; > 0 and <= 4096; default 4)"
std::string describe(const Entry& entry) {
  std::string facts;
  const auto add = [&](const std::string& fact) {
    if (!fact.empty()) facts += (facts.empty() ? "" : "; ") + fact;
  };
  add(entry.unit());
  if (entry.choices().empty()) {
    add(entry.range().text());
  } else if (typeName(entry) == "CHOICE") {
    add(entry.allowed());
  }
  const std::string standard = formatValue(entry.defaultValue());
  add("default " + (standard.empty() ? "none" : standard));
  return entry.help() + " (" + facts + ")";
}

/// The parsed subcommand furthest down, or the root.
const CLI::App& innermost(const CLI::App& root) {
  const CLI::App* app = &root;
  while (!app->get_subcommands().empty()) app = app->get_subcommands().back();
  return *app;
}

/// "; see macula replay --help"
std::string seeHelp(const CLI::App& app) {
  std::string name = app.get_name();
  for (const CLI::App* parent = app.get_parent(); parent != nullptr;
       parent = parent->get_parent()) {
    if (!parent->get_name().empty()) name = parent->get_name() + " " + name;
  }
  return "; see " + name + (name.empty() ? "" : " ") + "--help";
}

std::vector<std::string> optionNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string> subcommandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands({})) {
    if (!sub->get_name().empty()) names.push_back(sub->get_name());
  }
  return names;
}

[[noreturn]] void failLeftover(const CLI::App& app, const std::string& argument) {
  const std::string shown = argument.substr(0, std::min(kShownCharacters, argument.find('=')));
  if (!shown.empty() && shown[0] == '-') {
    failInput("unknown option '{}'; the nearest is '{}'{}", shown,
              nearestName(shown, optionNames(app)), seeHelp(app));
  }
  const std::vector<std::string> commands = subcommandNames(app);
  if (!commands.empty()) {
    failInput("unknown subcommand '{}'; the nearest is '{}'{}", shown, nearestName(shown, commands),
              seeHelp(app));
  }
  failInput("unexpected argument '{}'{}", shown, seeHelp(app));
}

/// Every option of the line with its value, as the line was written. CLI11 notes the order of
/// options and keeps each one's values in order, so walking both in step gives the pairs; from the
/// back, because it keeps the order of earlier parses of the same app in front.
std::vector<std::pair<const CLI::Option*, std::string>> inOrder(const CLI::App& app) {
  std::vector<std::pair<const CLI::Option*, std::string>> pairs;
  std::map<const CLI::Option*, std::size_t> taken;
  const std::vector<CLI::Option*>& order = app.parse_order();
  for (auto at = order.rbegin(); at != order.rend(); ++at) {
    const std::vector<std::string>& values = (*at)->results();
    const std::size_t fromBack = ++taken[*at];
    if (fromBack <= values.size()) pairs.emplace_back(*at, values[values.size() - fromBack]);
  }
  std::reverse(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

void addOptions(CLI::App& app, const Registry& registry) {
  app.add_option(kConfig)
      ->description("Read settings from a TOML file; options on the line win over it (repeatable)")
      ->type_name("FILE.toml")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group("Settings");
  app.add_option(kSet)
      ->description("Set any setting by its key, for example oit.kAve=4 (repeatable)")
      ->type_name("KEY=VALUE")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group("Settings");
  for (const Entry& entry : registry.entries()) {
    const std::string alias = entry.alias().empty() ? "" : "--" + entry.alias() + ",";
    app.add_option(alias + "--" + entry.key())
        ->description(describe(entry))
        ->type_name(typeName(entry))
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->group(entry.group());
  }
}

void applyOptions(const CLI::App& app, Registry& registry) {
  const CLI::Option* config = app.get_option(kConfig);
  const CLI::Option* set = app.get_option(kSet);
  for (const std::string& path : config->results()) applyTomlFile(registry, path);

  std::map<const CLI::Option*, Entry*> entries;
  for (Entry& entry : registry.entries()) {
    if (const CLI::Option* option = app.get_option_no_throw("--" + entry.key())) {
      entries[option] = &entry;
    }
  }
  for (const auto& [option, text] : inOrder(app)) {
    if (option == set) {
      registry.setAssignment(text, kSet);
    } else if (const auto found = entries.find(option); found != entries.end()) {
      found->second->setText(text, found->second->option());
    }
  }
  registry.checkRivals();
}

CLI::Validator shareIn(const Range& range) {
  const auto refusal = [range](const std::string& text) {
    const std::optional<double> number = parseReal(text);
    if (number && range.holds(*number)) return std::string();
    return fmt::format("'{}' is no share {}{}", oneLine(text.substr(0, kShownCharacters)),
                       range.text(), shareHint(text, range));
  };
  return {[refusal](std::string& text) { return refusal(text); },
          fmt::format("FLOAT in [{} - {}]", range.min, range.max)};
}

bool parseCommandLine(CLI::App& root, std::vector<std::string> arguments) {
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes vectors from the back
  try {
    root.parse(std::move(arguments));
  } catch (const CLI::Success& asked) {
    root.exit(asked);  // prints the help or the version
    return false;
  } catch (const CLI::ParseError& error) {
    failCommandLine(root, error);
  }
  return true;
}

bool parseCommandLine(CLI::App& root, int argc, const char* const* argv) {
  return parseCommandLine(root, std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
}

void failCommandLine(const CLI::App& root, const CLI::ParseError& error) {
  // What CLI11 could not place explains more than its own complaint, which may be only that
  // something required is missing, when the required thing was mistyped.
  const CLI::App& app = innermost(root);
  const std::vector<std::string> left = root.remaining(true);
  const auto isOption = [](const std::string& text) { return text.size() > 1 && text[0] == '-'; };
  const auto option = std::find_if(left.begin(), left.end(), isOption);
  if (option != left.end()) failLeftover(app, *option);
  if (!left.empty()) failLeftover(app, left.front());
  failInput("{}{}", error.what(), seeHelp(app));
}

}  // namespace macula::settings
