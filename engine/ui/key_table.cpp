#include "engine/ui/key_table.h"

#include <imgui.h>

#include <algorithm>

namespace macula::ui {
namespace {

/// Lengths in heights of the font.
constexpr float kColumnWidth = 27.0F;
constexpr float kKeyWidth = 10.0F;
constexpr float kMargin = 1.0F;

void drawGroup(std::span<const KeyRow> rows) {
  ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_PlotLines), "%.*s",
                     static_cast<int>(rows.front().group.size()), rows.front().group.data());
  for (const KeyRow& row : rows) {
    const float left = ImGui::GetCursorPosX();
    ImGui::TextUnformatted(row.keys.data(), row.keys.data() + row.keys.size());
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + kKeyWidth * ImGui::GetFontSize());
    ImGui::PushTextWrapPos(left + (kColumnWidth - kMargin) * ImGui::GetFontSize());
    ImGui::TextUnformatted(row.what.data(), row.what.data() + row.what.size());
    ImGui::PopTextWrapPos();
  }
  ImGui::Spacing();
}

/// Rows of one group at the beginning of the span.
std::span<const KeyRow> firstGroup(std::span<const KeyRow> rows) {
  const auto end = std::find_if(rows.begin(), rows.end(),
                                [&](const KeyRow& row) { return row.group != rows.front().group; });
  return rows.first(static_cast<std::size_t>(end - rows.begin()));
}

}  // namespace

bool drawKeyTable(std::span<const KeyRow> rows) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float em = ImGui::GetFontSize();
  const float padding = 2.0F * ImGui::GetStyle().WindowPadding.x;
  const bool wide = size.x > 2.0F * kColumnWidth * em + padding + 2.0F * kMargin * em;
  const float width = (wide ? 2.0F : 1.0F) * kColumnWidth * em + padding;
  ImGui::SetNextWindowPos({0.5F * size.x, 0.5F * size.y}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSizeConstraints({width, 0.0F},
                                      {width + padding, size.y - 2.0F * kMargin * em});
  ImGui::SetNextWindowBgAlpha(1.0F);
  bool open = true;
  ImGui::Begin("Keys", &open,
               ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
  const std::size_t half = (rows.size() + 1) / 2;
  std::size_t drawn = 0;
  bool second = !wide;
  if (wide) ImGui::Columns(2, nullptr, false);
  for (std::span<const KeyRow> rest = rows; !rest.empty();) {
    const std::span<const KeyRow> group = firstGroup(rest);
    if (!second && drawn > 0 && drawn + group.size() / 2 > half) {
      ImGui::NextColumn();
      second = true;
    }
    drawGroup(group);
    drawn += group.size();
    rest = rest.subspan(group.size());
  }
  if (wide) ImGui::Columns(1);
  ImGui::End();
  return !open;
}

}  // namespace macula::ui
