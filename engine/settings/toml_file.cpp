#define TOML_IMPLEMENTATION  // toml++ is compiled in this file alone

#include "engine/settings/toml_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/file.h"

namespace macula::settings {
namespace {

/// A file of settings or an experiment is a few kilobytes; this stops a wrong file early.
constexpr std::size_t kMaxTomlBytes = std::size_t{1} << 20;

/// Each part of a dotted key is a table within the one before, and toml++ frees them recursively.
/// This and TOML_MAX_NESTED_VALUES keep them some thousand deep, within any stack.
constexpr std::size_t kMaxDotsPerLine = 256;

/// No setting's key has this many parts; what lies deeper is reported as unknown.
constexpr int kMaxDepth = 8;

/// Applies one table and remembers which settings it has set.
class Applier {
 public:
  Applier(Registry& registry, std::string_view name) : registry_(registry), name_(name) {}

  void apply(const toml::table& table, const std::string& prefix, int depth = 0) {
    for (const auto& [tomlKey, node] : table) {
      const std::string key =
          prefix.empty() ? std::string(tomlKey.str()) : prefix + "." + std::string(tomlKey.str());
      const toml::table* inner = node.as_table();
      const bool isSection = inner != nullptr && !(inner->is_inline() && inner->empty());
      if (isSection && depth < kMaxDepth) {
        apply(*inner, key, depth + 1);
      } else {
        set(key, node, tomlKey.source().begin.line);
      }
    }
  }

 private:
  void set(const std::string& key, const toml::node& node, toml::source_index line) {
    const std::string place = fmt::format("{}:{}", name_, line);
    Entry& entry = registry_.at(key, place);
    if (!seen_.insert(&entry).second) {
      failInput("{}: {} is set twice in this file, by its key and by its alias; keep one", place,
                entry.key());
    }
    const std::string where = place + ": " + key;
    if (const auto value = convert(node, entry, where)) {
      entry.set(*value, where);
    } else {
      failInput("{}: is a TOML {}; {} takes {}", where, kind(node), entry.key(), entry.allowed());
    }
  }

  /// The node as a value, or nothing where TOML's type is one that no setting has.
  static std::optional<Value> convert(const toml::node& node, Entry& entry,
                                      const std::string& where) {
    if (const auto flag = node.value_exact<bool>()) return *flag;
    if (const auto number = node.value_exact<std::int64_t>()) return *number;
    if (const auto number = node.value_exact<double>()) return *number;
    if (const auto text = node.value_exact<std::string>()) {
      if (entry.type() != Type::Colour) return *text;
      entry.setText(*text, where);
      return entry.get();
    }
    const toml::array* list = node.as_array();
    if (list == nullptr || entry.type() != Type::Colour || list->size() != 3) return std::nullopt;
    glm::vec3 colour{0.0F};
    for (int i = 0; i < 3; ++i) {
      const auto number = list->get(static_cast<std::size_t>(i))->value<double>();
      // A number too large for a float would be undefined to convert; as infinity it is refused.
      if (!number) return std::nullopt;
      const bool fits = std::abs(*number) <= std::numeric_limits<float>::max();
      colour[i] = fits ? static_cast<float>(*number) : std::numeric_limits<float>::infinity();
    }
    return colour;
  }

  static std::string_view kind(const toml::node& node) {
    if (node.is_array()) return "array";
    if (node.is_table()) return "table";
    if (node.is_date() || node.is_time() || node.is_date_time()) return "date or time";
    return "value of another type";
  }

  Registry& registry_;
  std::string_view name_;
  std::set<const Entry*> seen_;
};

std::string_view lineOf(std::string_view text, toml::source_index number) {
  for (; number > 1; --number) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

/// How a value that is a bare word is to be written: on a command line words need no quotes.
/// @param column of the parser's complaint, from 1: in the value, behind its equals sign
std::string hintOf(std::string_view line, std::size_t column) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t equals = line.substr(0, column - 1).rfind('=');
  if (equals == std::string_view::npos) return {};
  std::string_view word = line.substr(equals + 1);
  word = word.substr(0, word.find_first_of(",#}]"));
  const std::size_t first = word.find_first_not_of(kBlanks);
  if (first == std::string_view::npos ||
      std::isalpha(static_cast<unsigned char>(word[first])) == 0) {
    return {};
  }
  word = word.substr(first, word.find_last_not_of(kBlanks) + 1 - first);
  std::string plain(word);
  std::transform(plain.begin(), plain.end(), plain.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (plain == "yes") plain = "on";
  if (plain == "no") plain = "off";
  if (const auto flag = parseBool(plain)) return fmt::format("; write {}", *flag);
  constexpr std::size_t kShownCharacters = 40;
  const bool isWord =
      word.size() <= kShownCharacters && word.find_first_of("\"'= \t") == std::string_view::npos;
  return isWord ? fmt::format("; text stands in quotes, \"{}\"", word) : "";
}

void checkDots(std::string_view text, std::string_view name) {
  toml::source_index line = 1;
  std::size_t dots = 0;
  for (const char c : text) {
    if (c == '\n') {
      ++line;
      dots = 0;
    } else if (c == '.' && ++dots > kMaxDotsPerLine) {
      failInput("{}:{}: more than {} dots; shorten the key, or break the list into lines", name,
                line, kMaxDotsPerLine);
    }
  }
}

bool failsAssertion(std::string_view text) {
  try {
    static_cast<void>(toml::parse(text));
  } catch (const TomlAssertion&) {
    return true;
  } catch (const toml::parse_error&) {
  }
  return false;
}

/// Assertions have no place in the text: this is the first line with which one fails.
std::size_t lineOfAssertion(std::string_view text) {
  std::vector<std::size_t> ends;  // of the lines
  for (std::size_t at = text.find('\n'); at != std::string_view::npos;
       at = text.find('\n', at + 1)) {
    ends.push_back(at + 1);
  }
  const auto first = std::partition_point(ends.begin(), ends.end(), [&](std::size_t end) {
    return !failsAssertion(text.substr(0, end));
  });
  return static_cast<std::size_t>(first - ends.begin()) + 1;
}

}  // namespace

toml::table parseToml(std::string_view text, std::string_view name) {
  if (text.size() > kMaxTomlBytes) {
    failInput("{}: {} bytes are more than the {} that a TOML file may have; check the path", name,
              text.size(), kMaxTomlBytes);
  }
  checkDots(text, name);
  try {
    return toml::parse(text);
  } catch (const TomlAssertion&) {
    failInput("{}:{}: is no TOML; check the brackets, quotes and signs of this line", name,
              lineOfAssertion(text));
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    failInput("{}:{}:{}: {}{}", name, at.line, at.column, error.description(),
              hintOf(lineOf(text, at.line), at.column));
  }
}

void applyTable(Registry& registry, const toml::table& table, std::string_view name) {
  Applier(registry, name).apply(table, "");
}

void applyTomlText(Registry& registry, std::string_view text, std::string_view name) {
  applyTable(registry, parseToml(text, name), name);
}

void applyTomlFile(Registry& registry, const std::filesystem::path& path) {
  applyTomlText(registry, readTextFile(path), path.string());
}

}  // namespace macula::settings
