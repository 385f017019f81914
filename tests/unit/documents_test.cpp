// Tables of the documents that the program knows: they are current, or MACULA_UPDATE=1 writes them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "engine/control/control_settings.h"
#include "engine/core/file.h"
#include "engine/gaze/gaze_settings.h"
#include "engine/gaze/quality.h"
#include "engine/settings/registry.h"
#include "passes/oit/methods.h"
#include "passes/render_settings.h"

namespace macula {
namespace {

/// Text of one cell of a Markdown table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, "\\");
  }
  return text;
}

std::string valuesOf(const settings::Entry& entry) {
  const std::string unit = entry.unit().empty() ? "" : fmt::format(" ({})", entry.unit());
  if (entry.type() == settings::Type::Bool) return "`on`, `off`";
  if (entry.choices().empty()) return entry.allowed() + unit;
  std::string text;
  for (const std::string& choice : entry.choices()) {
    text += fmt::format("{}`{}`", text.empty() ? "" : ", ", choice);
  }
  return text + unit;
}

std::string rowOf(const settings::Entry& entry) {
  std::string names = fmt::format("`--{}`", entry.key());
  if (!entry.alias().empty()) names = fmt::format("`--{}`, {}", entry.alias(), names);
  const std::string standard = settings::formatValue(entry.defaultValue());
  return fmt::format("| {} | {} | {} | {} |\n", names, cell(valuesOf(entry)),
                     standard.empty() ? "" : fmt::format("`{}`", standard), cell(entry.help()));
}

/// A table for each group, in the order in which groups first appear.
std::string optionTable(const settings::Registry& registry) {
  std::vector<std::pair<std::string, std::string>> groups;
  for (const settings::Entry& entry : registry.entries()) {
    auto group = std::ranges::find(groups, entry.group(), &decltype(groups)::value_type::first);
    if (group == groups.end()) group = groups.insert(group, {entry.group(), ""});
    group->second += rowOf(entry);
  }
  std::string text;
  for (const auto& [name, rows] : groups) {
    text += fmt::format("\n### {}\n\n| option | takes | default | meaning |\n|---|---|---|---|\n{}",
                        name, rows);
  }
  return text;
}

std::string methodTable() {
  std::string text = "\n| `--method` | what it does | exact | source |\n|---|---|---|---|\n";
  for (const passes::Method& method : passes::methods()) {
    text += fmt::format("| `{}` | {} | {} | {} |\n", method.id, method.summary,
                        method.exact ? "yes" : "", method.source);
  }
  return text + "\n";
}

/// The text of a page between `<!-- NAME -->` and `<!-- /NAME -->` is this.
void expectBlock(const std::string& page, const std::string& name, const std::string& expected) {
  const std::string path = MACULA_SOURCE_DIR "/docs/" + page;
  std::string text = readTextFile(path);
  const std::string begin = fmt::format("<!-- {} -->\n", name);
  const std::size_t from = text.find(begin);
  const std::size_t to = text.find(fmt::format("<!-- /{} -->", name));
  ASSERT_TRUE(from != std::string::npos && to != std::string::npos) << page << ": no " << begin;
  const std::size_t first = from + begin.size();
  if (std::getenv("MACULA_UPDATE") != nullptr) {
    text.replace(first, to - first, expected);
    writeFileAtomically(path, text);
    return;
  }
  EXPECT_EQ(text.substr(first, to - first), expected)
      << page << " is not current: run this test with MACULA_UPDATE=1";
}

TEST(Documents, ListEveryRendererSetting) {
  settings::Registry registry;
  passes::RenderSettings settings;
  passes::registerSettings(registry, settings);
  expectBlock("usage/options.md", "renderer settings", optionTable(registry) + "\n");
}

TEST(Documents, ListEveryGazeSetting) {
  settings::Registry registry;
  gaze::GazeSettings settings;
  gaze::QualityOptions quality;
  gaze::registerSettings(registry, settings);
  gaze::registerSettings(registry, quality);
  expectBlock("usage/options.md", "gaze settings", optionTable(registry) + "\n");
}

TEST(Documents, ListEveryControlSetting) {
  settings::Registry registry;
  control::ControlSettings settings;
  control::registerSettings(registry, settings);
  expectBlock("usage/options.md", "control settings", optionTable(registry) + "\n");
}

TEST(Documents, ListEveryMethod) {
  expectBlock("methods.md", "methods", methodTable());
}

}  // namespace
}  // namespace macula
