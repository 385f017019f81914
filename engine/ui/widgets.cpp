#include "engine/ui/widgets.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <cstddef>

#include "engine/core/plural.h"

namespace macula::ui {
namespace {

ImVec4 colorOf(Tone tone) {
  switch (tone) {
    case Tone::Quiet:
      return ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
    case Tone::Good:
      return {0.55F, 0.88F, 0.55F, 1.0F};
    case Tone::Warning:
      return {0.98F, 0.80F, 0.35F, 1.0F};
    case Tone::Error:
      return {1.0F, 0.55F, 0.45F, 1.0F};
    case Tone::Plain:
      break;
  }
  return ImGui::GetStyleColorVec4(ImGuiCol_Text);
}

float widthOf(std::string_view text) {
  return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

}  // namespace

void nameValue(std::string_view name, std::string_view value, Tone tone) {
  const float width = ImGui::GetContentRegionAvail().x;
  const float left = ImGui::GetCursorPosX();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  ImGui::TextUnformatted(name.data(), name.data() + name.size());
  const float valueWidth = widthOf(value);
  if (widthOf(name) + gap + valueWidth <= width) {
    ImGui::SameLine(left + width - valueWidth);
    ImGui::PushStyleColor(ImGuiCol_Text, colorOf(tone));
    ImGui::TextUnformatted(value.data(), value.data() + value.size());
    ImGui::PopStyleColor();
  } else {
    note(value, tone);
  }
}

void note(std::string_view text, Tone tone) {
  ImGui::PushStyleColor(ImGuiCol_Text, colorOf(tone));
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

bool flowButton(const std::string& label, bool first) {
  const ImGuiStyle& style = ImGui::GetStyle();
  // What stands behind ## is no part of what is shown.
  const std::string_view shown = std::string_view(label).substr(0, label.find("##"));
  const float width = widthOf(shown) + 2.0F * style.FramePadding.x;
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (!first && ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= right) {
    ImGui::SameLine();
  }
  return ImGui::Button(label.c_str());
}

std::optional<std::size_t> chips(std::span<const std::string_view> names,
                                 std::optional<std::size_t> chosen) {
  std::optional<std::size_t> pressed;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool lit = chosen && *chosen == i;
    if (lit) {
      ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    }
    if (flowButton(std::string(names[i]), i == 0)) pressed = i;
    if (lit) ImGui::PopStyleColor();
  }
  return pressed;
}

void pictureLabel(std::string_view text, glm::vec2 place, float anchor) {
  const char* end = text.data() + text.size();
  const ImVec2 size = ImGui::CalcTextSize(text.data(), end);
  const float pad = 0.3F * ImGui::GetFontSize();
  const float left = std::floor(place.x - anchor * (size.x + 2.0F * pad)) + pad;
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  list->AddRectFilled({left - pad, place.y}, {left + size.x + pad, place.y + size.y + 2.0F * pad},
                      IM_COL32(10, 12, 16, 190), pad);
  list->AddText({left, place.y + pad}, IM_COL32(255, 255, 255, 255), text.data(), end);
}

void bringToFront() {
  // The public way, SetWindowFocus(), would take the keyboard from a field that is being typed in.
  ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
}

std::string bytesText(unsigned long long bytes) {
  constexpr double kKibi = 1024.0;
  const double kibi = static_cast<double>(bytes) / kKibi;
  return kibi < kKibi ? fmt::format("{:.1f} KiB", kibi) : fmt::format("{:.2f} MiB", kibi / kKibi);
}

std::string countText(unsigned long long count) {
  std::string text = std::to_string(count);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3) {
    text.insert(static_cast<std::size_t>(at), 1, ' ');
  }
  return text;
}

std::string numberOf(unsigned long long count, std::string_view thing) {
  return fmt::format("{} {}", countText(count), nounFor(count, thing));
}

}  // namespace macula::ui
