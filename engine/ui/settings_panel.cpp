#include "engine/ui/settings_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <utility>

#include "engine/core/error.h"

namespace macula::ui {
namespace {

using settings::Entry;
using settings::Value;

/// Share of a row that names the setting.
constexpr float kNameShare = 0.36F;
constexpr float kTooltipEms = 28.0F;  ///< width of a tooltip in heights of the font

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

void SettingsPanel::change(Entry& entry, const Value& value) {
  const Value before = entry.get();
  try {
    entry.set(value);
  } catch (const InputError& error) {
    refusal_ = error.what();
    return;
  }
  refusal_.clear();
  if (entry.get() != before) change_ = SettingChange{&entry, before};
}

void SettingsPanel::row(Entry& entry) {
  const bool fixed = isFixed(entry);
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(entry.key().c_str());
  ImGui::BeginGroup();
  ImGui::AlignTextToFramePadding();
  if (entry.isDefault()) {
    ImGui::TextUnformatted(nameInGroup(entry).c_str());
  } else {
    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_PlotLines), "%s",
                       nameInGroup(entry).c_str());
  }
  ImGui::SameLine(kNameShare * width);  // from the left edge of the group
  ImGui::SetNextItemWidth((1.0F - kNameShare) * width);
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

void SettingsPanel::groups() {
  std::vector<std::string> names;
  for (const Entry& entry : registry_.entries()) {
    if (std::find(names.begin(), names.end(), entry.group()) == names.end()) {
      names.push_back(entry.group());
    }
  }
  for (const std::string& name : names) {
    if (!ImGui::CollapsingHeader(name.c_str())) continue;
    ImGui::PushID(name.c_str());
    for (Entry& entry : registry_.entries()) {
      if (entry.group() == name) row(entry);
    }
    ImGui::PopID();
  }
}

void SettingsPanel::chooseNext(const std::string& key) {
  Entry& entry = registry_.at(key, key);
  const std::vector<std::string>& choices = entry.choices();
  const auto present =
      std::find(choices.begin(), choices.end(), settings::formatValue(entry.get()));
  if (choices.empty() || isFixed(entry)) return;
  const bool last = present == choices.end() || present + 1 == choices.end();
  change(entry, last ? choices.front() : *(present + 1));
}

std::optional<SettingChange> SettingsPanel::takeChange() {
  return std::exchange(change_, {});
}

}  // namespace macula::ui
