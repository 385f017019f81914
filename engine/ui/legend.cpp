#include "engine/ui/legend.h"

#include <imgui.h>

#include <array>
#include <glm/glm.hpp>

#include "shared/viridis.h"

namespace macula::ui {
namespace {

const std::array<glm::vec3, VIRIDIS_POINTS> kViridis{glm::dvec3{VIRIDIS_0}, glm::dvec3{VIRIDIS_1},
                                                     glm::dvec3{VIRIDIS_2}, glm::dvec3{VIRIDIS_3},
                                                     glm::dvec3{VIRIDIS_4}};

ImU32 packed(const glm::vec3& color) {
  return ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, 1.0F});
}

void drawBar(const ImVec2& corner, float width, float height) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  constexpr auto kSegments = static_cast<float>(kViridis.size() - 1);
  for (std::size_t i = 0; i + 1 < kViridis.size(); ++i) {
    const float left = corner.x + width * static_cast<float>(i) / kSegments;
    const ImU32 from = packed(kViridis[i]);
    const ImU32 to = packed(kViridis[i + 1]);
    list->AddRectFilledMultiColor({left, corner.y}, {left + width / kSegments, corner.y + height},
                                  from, to, to, from);
  }
}

}  // namespace

void drawLegend(const Legend& legend) {
  ImGui::TextWrapped("%s", legend.quantity.c_str());
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ImGui::GetTextLineHeight();
  drawBar(ImGui::GetCursorScreenPos(), width, height);
  ImGui::Dummy({width, height});

  const float left = ImGui::GetCursorPosX();
  const auto label = [&](float share, const std::string& text) {
    const float textWidth = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorPosX(left + share * (width - textWidth));
    ImGui::TextUnformatted(text.c_str());
  };
  const image::LegendLabels labels = image::labelsOf(legend);
  label(0.0F, labels.low);
  ImGui::SameLine();
  label(0.5F, labels.middle);
  ImGui::SameLine();
  label(1.0F, labels.high);
  if (!legend.grey.empty()) ImGui::TextDisabled("grey: %s", legend.grey.c_str());
}

}  // namespace macula::ui
