#include "walk_panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

#include "engine/ui/legend.h"

namespace macula::tools {
namespace {

/// Lengths of the layout in heights of the font, so that it follows the content scale.
constexpr float kMargin = 0.6F;
constexpr float kPanelWidth = 24.0F;
/// Narrower windows, in widths of a panel, begin with the numbers folded.
constexpr float kNarrow = 3.0F;
constexpr float kWidestShare = 0.45F;  ///< of the window for one panel

constexpr std::array<std::string_view, 8> kHelp{
    "WASD, QE fly", "Shift faster", "wheel speed", "right button or arrows look",
    "R reset",      "M method",     "H heat map",  "F1 panels"};

struct MapWords {
  std::string_view map;
  const char* quantity;
  bool mayExceed;
};

constexpr std::array kMapWords{
    MapWords{"k", "k(p): slots of each sample", true},
    MapWords{"depth-complexity", "transparent fragments of each sample", true},
    MapWords{"importance", "importance, Eq. 6", false},
    MapWords{"periphery", "periphery factor, Eq. 4", false},
    MapWords{"depth-factor", "depth complexity factor, Eq. 3", false},
    MapWords{"fresnel", "Fresnel factor, Eq. 5", false},
};

std::string bytesText(std::uint64_t bytes) {
  constexpr double kMebi = 1024.0 * 1024.0;
  return fmt::format("{:.2f} MiB", static_cast<double>(bytes) / kMebi);
}

/// Digits in groups of three.
std::string countText(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3) {
    text.insert(static_cast<std::size_t>(at), 1, ' ');
  }
  return text;
}

/// Name at the left, value at the right edge of the panel.
void line(const char* name, const std::string& value) {
  const float width = ImGui::GetContentRegionAvail().x;
  const float left = ImGui::GetCursorPosX();
  ImGui::TextUnformatted(name);
  ImGui::SameLine(left + width - ImGui::CalcTextSize(value.c_str()).x);
  ImGui::TextUnformatted(value.c_str());
}

void drawRing(glm::vec2 gaze) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const ImVec2 center(gaze.x * size.x, gaze.y * size.y);
  const float radius = 0.6F * ImGui::GetFontSize();
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  // A dark ring under a light one stands out against any image.
  list->AddCircle(center, radius, IM_COL32(0, 0, 0, 200), 0, 4.0F);
  list->AddCircle(center, radius, IM_COL32(255, 255, 255, 230), 0, 1.5F);
}

/// The keys in as many lines as the width asks for, never cut within an item.
std::string helpText(float width) {
  constexpr const char* kGap = "    ";
  std::string text;
  std::string line;
  for (const std::string_view item : kHelp) {
    const std::string longer = line.empty() ? std::string(item) : line + kGap + std::string(item);
    if (line.empty() || ImGui::CalcTextSize(longer.c_str()).x <= width) {
      line = longer;
      continue;
    }
    text += line + "\n";
    line = item;
  }
  return text + line;
}

/// Draws the keys in a bar over the whole width. @returns its height
float drawHelp() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  const std::string text = helpText(size.x - 2.0F * padding.x);
  const float height = ImGui::CalcTextSize(text.c_str()).y + padding.y;
  ImGui::SetNextWindowPos({0.0F, size.y - height});
  ImGui::SetNextWindowSize({size.x, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padding.x, 0.5F * padding.y));
  // Shorter than what windows otherwise begin with.
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
  ImGui::Begin("keys", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings);
  ImGui::TextUnformatted(text.c_str());
  ImGui::End();
  ImGui::PopStyleVar(3);
  return height;
}

void drawFragments(const passes::FrameResult& result) {
  if (!result.fragments) {
    ImGui::TextDisabled("fragments are not counted by this method");
    return;
  }
  line("fragments", countText(result.fragments->generated));
  line("  stored", countText(result.fragments->stored));
  if (result.fragments->merged > 0) line("  merged", countText(result.fragments->merged));
  const auto generated =
      static_cast<double>(std::max<std::uint64_t>(1, result.fragments->generated));
  constexpr double kPercent = 100.0;
  line("  lost", fmt::format("{} ({:.1f} %)", countText(result.fragments->lost),
                             kPercent * static_cast<double>(result.fragments->lost) / generated));
  line("deepest sample", std::to_string(result.deepest));
  if (result.layers) {
    line("k least, mean, most", fmt::format("{}, {:.2f}, {}", result.layers->min,
                                            result.layers->mean, result.layers->max));
  }
}

}  // namespace

WalkPanels::WalkPanels(settings::Registry& registry, const passes::RenderSettings& settings,
                       std::string sceneName)
    : renderSettings_(settings),
      sceneName_(std::move(sceneName)),
      // These go into the scene while it is loaded.
      panel_(registry, {"scene.environment", "scene.lighting", "scene.order", "frame.seed"}) {}

void WalkPanels::add(const passes::FrameResult& result) {
  std::vector<ui::TimeRow> rows;
  rows.reserve(result.passes.size());
  for (const frame::PassTime& pass : result.passes) rows.push_back({pass.name, pass.ms});
  timings_.add(rows, result.totalMs);
}

void WalkPanels::draw(const passes::FrameRenderer& renderer, const passes::FrameResult& result,
                      glm::vec2 gaze) {
  drawRing(gaze);
  const float helpHeight = drawHelp();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float em = ImGui::GetFontSize();
  const float margin = kMargin * em;
  const float width = std::min(kPanelWidth * em, kWidestShare * size.x);
  const ImVec2 most(width, std::max(4.0F * em, size.y - helpHeight - 2.0F * margin));
  const ImGuiWindowFlags flags = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                 ImGuiWindowFlags_AlwaysAutoResize |
                                 ImGuiWindowFlags_NoSavedSettings;

  ImGui::SetNextWindowPos({margin, margin});
  ImGui::SetNextWindowSizeConstraints({width, 0.0F}, most);
  if (ImGui::Begin("View", nullptr, flags)) drawView(renderer);
  ImGui::End();

  ImGui::SetNextWindowPos({size.x - margin - width, margin});
  ImGui::SetNextWindowSizeConstraints({width, 0.0F}, most);
  ImGui::SetNextWindowCollapsed(size.x < kNarrow * width, ImGuiCond_Once);
  if (ImGui::Begin("Numbers", nullptr, flags)) drawNumbers(renderer, result);
  ImGui::End();
}

void WalkPanels::drawView(const passes::FrameRenderer& renderer) {
  const glm::ivec2 size = renderer.outputSize();
  line(sceneName_.c_str(), fmt::format("{} x {}", size.x, size.y));
  panel_.row("oit.method");
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TextWrapped("%.*s", static_cast<int>(renderer.plan().method->summary.size()),
                     renderer.plan().method->summary.data());
  ImGui::PopStyleColor();
  if (renderer.plan().method->hasBudget()) {
    panel_.row("oit.kAve");
    panel_.row("oit.memoryMiB");
    panel_.row("oit.tail");
  }
  if (renderer.plan().method->allocation == passes::Allocation::ImportanceMap) {
    panel_.row("oit.fill");
    panel_.row("oit.importance");
  }
  panel_.row("view.heatmap");
  drawLegend(renderer);
  if (!panel_.refusal().empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0F, 0.55F, 0.45F, 1.0F));
    ImGui::TextWrapped("%s", panel_.refusal().c_str());
    ImGui::PopStyleColor();
  }
  ImGui::Separator();
  ImGui::TextDisabled("All settings");
  panel_.groups();
}

void WalkPanels::drawLegend(const passes::FrameRenderer& renderer) const {
  const std::string& map = renderSettings_.heatmap.map;
  const auto words = std::find_if(kMapWords.begin(), kMapWords.end(),
                                  [&](const MapWords& row) { return row.map == map; });
  if (words == kMapWords.end()) return;
  for (const frame::PassReport& pass : renderer.report()) {
    if (pass.name == "heatmap" && !pass.runs) {
      ImGui::TextWrapped("Not shown: %s.", pass.reason.c_str());
      return;
    }
  }
  ui::drawLegend({words->quantity, passes::heatmapRange(renderSettings_.heatmap, renderer.plan()),
                  words->mayExceed});
}

void WalkPanels::drawNumbers(const passes::FrameRenderer& renderer,
                             const passes::FrameResult& result) {
  timings_.draw();
  ImGui::Separator();
  drawFragments(result);
  line("every fragment shown", result.exact ? "yes" : "no");
  if (result.lockFailures > 0) line("locks given up", countText(result.lockFailures));
  ImGui::Separator();
  const frame::ResourceBytes bytes = renderer.bytes();
  line("fragment storage", bytesText(bytes.oit));
  if (renderer.plan().budgetBytes) line("  budget", bytesText(*renderer.plan().budgetBytes));
  line("counts and maps", bytesText(bytes.overhead));
  line("G-buffer", bytesText(bytes.gbuffer));
  line("other images", bytesText(bytes.other));
}

}  // namespace macula::tools
