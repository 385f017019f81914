#include "engine/ui/settings_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

#include "engine/core/error.h"

namespace macula::ui {
namespace {

using settings::Entry;
using settings::Value;

/// Share of a row that names the setting.
constexpr float kNameShare = 0.36F;
constexpr float kTooltipEms = 28.0F;  ///< width of a tooltip in heights of the font

std::string lowered(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// All that a search looks at, in lower case.
std::string searchedText(const Entry& entry) {
  std::string text = entry.key() + '\n' + entry.alias() + '\n' + entry.unit() + '\n' + entry.help();
  for (const std::string& choice : entry.choices()) text += '\n' + choice;
  return lowered(text);
}

/// A setting's name below its group: "kAve" of "oit.kAve".
std::string nameInGroup(const Entry& entry) {
  const std::string& key = entry.key();
  return key.substr(key.find('.') == std::string::npos ? 0 : key.find('.') + 1);
}

void drawTooltip(const Entry& entry, bool fixed) {
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(kTooltipEms * ImGui::GetFontSize());
  ImGui::TextUnformatted(entry.key().c_str());
  ImGui::TextWrapped("%s", entry.help().c_str());
  ImGui::TextDisabled("takes %s%s%s", entry.allowed().c_str(), entry.unit().empty() ? "" : ", in ",
                      entry.unit().c_str());
  ImGui::TextDisabled("default %s", settings::formatValue(entry.defaultValue()).c_str());
  ImGui::TextDisabled("%s on the command line", entry.option().c_str());
  ImGui::TextDisabled(fixed ? "cannot be changed while the scene is shown"
                            : "right click: default");
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace

SettingsPanel::SettingsPanel(settings::Registry& registry, std::vector<std::string> fixed)
    : registry_(registry), fixed_(std::move(fixed)) {}

bool SettingsPanel::isFixed(const Entry& entry) const {
  return std::find(fixed_.begin(), fixed_.end(), entry.key()) != fixed_.end();
}

template <typename Setter>
void SettingsPanel::tryToSet(Entry& entry, Setter&& setter) {
  const Value before = entry.get();
  try {
    setter(entry);
  } catch (const InputError& error) {
    refusal_ = error.what();
    return;
  }
  refusal_.clear();
  if (entry.get() == before) return;
  change_ = SettingChange{&entry, before};
  if (Entry* rival = registry_.rivalOf(entry)) {
    change_->rival = rival;
    change_->rivalBefore = rival->get();
    rival->reset();
  }
}

void SettingsPanel::change(Entry& entry, const Value& value) {
  tryToSet(entry, [&](Entry& setting) { setting.set(value); });
}

void SettingsPanel::assign(std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) {
    failInput("'{}' sets nothing; write KEY=VALUE", oneLine(assignment));
  }
  const std::string key(assignment.substr(0, equals));
  tryToSet(registry_.at(key, key),
           [&](Entry& setting) { setting.setText(assignment.substr(equals + 1), setting.key()); });
}

void SettingsPanel::row(Entry& entry) {
  const bool fixed = isFixed(entry);
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(entry.key().c_str());
  ImGui::BeginGroup();
  const std::string name = nameInGroup(entry);
  ImGui::AlignTextToFramePadding();
  if (entry.isDefault()) {
    ImGui::TextUnformatted(name.c_str());
  } else {
    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_PlotLines), "%s", name.c_str());
  }
  // A name too long for its column, in a narrow panel, has a line of its own.
  if (ImGui::CalcTextSize(name.c_str()).x < kNameShare * width) {
    ImGui::SameLine(kNameShare * width);  // from the left edge of the group
    ImGui::SetNextItemWidth((1.0F - kNameShare) * width);
  } else {
    ImGui::SetNextItemWidth(width);
  }
  ImGui::BeginDisabled(fixed);
  const std::optional<Value> chosen = drawSettingWidget(entry, pending_);
  ImGui::EndDisabled();
  ImGui::EndGroup();
  ImGui::PopID();
  if (chosen) change(entry, *chosen);
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  if (!ImGui::IsAnyItemActive()) drawTooltip(entry, fixed);
  if (!fixed && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) change(entry, entry.defaultValue());
}

void SettingsPanel::row(const std::string& key) {
  row(registry_.at(key, key));
}

void SettingsPanel::groupRows(const std::string& group, bool matchesOnly) {
  ImGui::PushID(group.c_str());
  for (Entry& entry : registry_.entries()) {
    if (entry.group() == group && (!matchesOnly || matchesQuery(entry, query_))) row(entry);
  }
  ImGui::PopID();
}

void SettingsPanel::searchableGroups(std::span<const std::string_view> only) {
  if (std::exchange(focusSearch_, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  ImGui::InputTextWithHint("##search", "search settings", &query_);
  std::vector<std::string> names;
  int hits = 0;
  for (const Entry& entry : registry_.entries()) {
    if (!only.empty() && std::find(only.begin(), only.end(), entry.group()) == only.end()) continue;
    if (!matchesQuery(entry, query_)) continue;
    ++hits;
    if (std::find(names.begin(), names.end(), entry.group()) == names.end()) {
      names.push_back(entry.group());
    }
  }
  const bool searching = query_.find_first_not_of(' ') != std::string::npos;
  hits_ = searching ? std::optional<int>(hits) : std::nullopt;
  if (hits == 0) ImGui::TextDisabled("no setting holds these words");
  for (const std::string& name : names) {
    if (searching) {
      ImGui::TextDisabled("%s", name.c_str());
    } else if (!ImGui::CollapsingHeader(name.c_str())) {
      continue;
    }
    groupRows(name, searching);
  }
}

void SettingsPanel::chooseNext(const std::string& key) {
  Entry& entry = registry_.at(key, key);
  if (entry.choices().empty() || isFixed(entry)) return;
  const SettingChange cycle{&entry, entry.get(), true};
  if (!cycle.advance()) return;
  refusal_.clear();
  change_ = cycle;
}

void SettingChange::undo() const {
  entry->set(before);
  if (rival != nullptr) rival->set(rivalBefore);
}

std::string SettingChange::rivalNote() const {
  if (rival == nullptr) return {};
  return rival->key() + " is " + settings::formatValue(rival->get()) + " again: " + entry->key() +
         " holds in its place";
}

bool SettingChange::advance() const {
  const std::vector<std::string>& choices = entry->choices();
  const auto present =
      std::find(choices.begin(), choices.end(), settings::formatValue(entry->get()));
  const bool last = present == choices.end() || present + 1 == choices.end();
  entry->setText(last ? choices.front() : *(present + 1), entry->key());
  return entry->get() != before;
}

std::optional<SettingChange> SettingsPanel::takeChange() {
  return std::exchange(change_, {});
}

bool matchesQuery(const Entry& entry, std::string_view query) {
  const std::string text = searchedText(entry);
  std::istringstream words(lowered(query));
  for (std::string word; words >> word;) {
    if (text.find(word) == std::string::npos) return false;
  }
  return true;
}

}  // namespace macula::ui
