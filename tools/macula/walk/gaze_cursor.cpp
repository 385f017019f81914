#include "walk/gaze_cursor.h"

#include <imgui.h>

namespace macula::tools {
namespace {

constexpr float kRingEms = 0.6F;
constexpr ImU32 kShade = IM_COL32(0, 0, 0, 170);

}  // namespace

std::uint32_t colorOf(gaze::GazeState state) {
  switch (state) {
    case gaze::GazeState::Ok:
      return IM_COL32(150, 240, 160, 255);
    case gaze::GazeState::Held:
      return IM_COL32(250, 215, 80, 255);
    case gaze::GazeState::Lost:
      return IM_COL32(255, 100, 85, 255);
    case gaze::GazeState::Easing:
      return IM_COL32(255, 165, 70, 255);
    case gaze::GazeState::None:
    case gaze::GazeState::Ended:
      break;
  }
  return IM_COL32(170, 172, 178, 255);
}

void drawGazeCursor(const gaze::PointOfInterest& point, glm::vec2 low, glm::vec2 size) {
  const glm::vec2 place = low + point.position * size;
  const ImVec2 center(place.x, place.y);
  const float ring = kRingEms * ImGui::GetFontSize();
  const float fovea = point.radius * size.y;
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  list->PushClipRect({low.x, low.y}, {low.x + size.x, low.y + size.y});
  // A dark line under a light one stands out against any image.
  list->AddCircle(center, fovea, kShade, 0, 3.0F);
  list->AddCircle(center, fovea, colorOf(point.state), 0, 1.0F);
  list->AddCircle(center, ring, kShade, 0, 4.5F);
  list->AddCircle(center, ring, colorOf(point.state), 0, 2.0F);
  list->PopClipRect();
}

}  // namespace macula::tools
