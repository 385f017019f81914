// Panels: the view and settings tabs, and the numbers.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "engine/ui/legend.h"
#include "engine/ui/widgets.h"
#include "walk/panels.h"

namespace macula::tools {
namespace {

void drawHeatmapLegend(const PanelInput& input) {
  if (input.settings.heatmap.map == "none") return;
  if (const std::optional<ui::Legend> legend = input.renderer.legend()) {
    ui::drawLegend(*legend);
    return;
  }
  for (const frame::PassReport& pass : input.renderer.report()) {
    if (pass.name == "heatmap" && !pass.runs) {
      ui::note(fmt::format("Not shown: {}.", pass.reason), ui::Tone::Warning);
      return;
    }
  }
}

void drawFragments(const passes::FrameResult& result) {
  if (!result.fragments) {
    ImGui::TextDisabled("fragments are not counted by this method");
    return;
  }
  ui::nameValue("fragments", ui::countText(result.fragments->generated));
  ui::nameValue("  stored", ui::countText(result.fragments->stored));
  if (result.fragments->merged > 0) {
    ui::nameValue("  merged", ui::countText(result.fragments->merged));
  }
  const auto generated =
      static_cast<double>(std::max<std::uint64_t>(1, result.fragments->generated));
  constexpr double kPercent = 100.0;
  ui::nameValue("  lost",
                fmt::format("{} ({:.1f} %)", ui::countText(result.fragments->lost),
                            kPercent * static_cast<double>(result.fragments->lost) / generated));
  ui::nameValue("deepest sample", std::to_string(result.deepest));
  if (result.layers) {
    ui::nameValue("k least, mean, most", fmt::format("{}, {:.2f}, {}", result.layers->min,
                                                     result.layers->mean, result.layers->max));
  }
}

}  // namespace

void drawMethodTimes(const PanelInput& input) {
  const auto draw = [](const ui::MethodTime& time, std::string_view prefix) {
    ui::nameValue(fmt::format("{}{}", prefix, time.method()),
                  fmt::format("median {:.1f} ms", time.medianMs()));
  };
  const bool two = input.second.shown();
  draw(input.time, two ? "A, " : "");
  if (two) draw(input.second.time(), "B, ");
}

void Panels::drawControl(const PanelInput& input) {
  panel_.row("control.law");
  if (input.control.settings().law == "off") return;
  using control::Lever;
  panel_.row("control.targetMs");
  const control::Controller& controller = input.control.controller();
  ui::nameValue("r", fmt::format("{:.3f}", input.result.resizeFactor));
  const control::LeverValues& levers = controller.levers();
  if (levers[Lever::FoveaSlope] != 1.0 || levers[Lever::LayerShare] != 1.0) {
    ui::nameValue(
        "fovea's slope, layers",
        fmt::format("x {:.2f}, x {:.2f}", levers[Lever::FoveaSlope], levers[Lever::LayerShare]));
  }
  if (!resizes_.empty()) {
    constexpr float kLines = 2.5F;
    const float most = *std::max_element(resizes_.begin(), resizes_.end());
    ImGui::PlotLines("##r", resizes_.data(), static_cast<int>(resizes_.size()), 0, "r", 1.0F,
                     std::max(2.0F, most),
                     {ImGui::GetContentRegionAvail().x, kLines * ImGui::GetTextLineHeight()});
  }
  const std::string notice = controller.notice();
  if (!notice.empty()) ui::note(notice, ui::Tone::Warning);
}

void Panels::drawViewTab(const PanelInput& input, Requests& requests) {
  const passes::Method& method = *input.renderer.plan().method;
  const glm::ivec2 size = input.renderer.outputSize();
  ui::nameValue(input.scene.name, fmt::format("{} x {}", size.x, size.y));
  panel_.row("oit.method");
  ui::note(method.summary);
  if (method.hasBudget()) {
    panel_.row("oit.kAve");
    panel_.row("oit.memoryMiB");
    panel_.row("oit.tail");
  }
  if (method.followsImportance()) {
    panel_.row("oit.fill");
    panel_.row("oit.importance");
  }
  panel_.row("view.heatmap");
  drawHeatmapLegend(input);
  panel_.row("tonemap.exposure");
  ImGui::Separator();
  drawControl(input);
  ImGui::Separator();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  ImGui::InputTextWithHint("##picture", "name of the picture; empty: macula_001, ...",
                           &state_.pictureField);
  const auto fileName = [&](const char* extension) {
    return state_.pictureField.empty() ? std::string() : state_.pictureField + extension;
  };
  if (ui::flowButton("PNG", true)) requests.push_back({Action::Png, fileName(".png")});
  if (ui::flowButton("EXR, linear", false)) requests.push_back({Action::Exr, fileName(".exr")});
  if (ui::flowButton("copy as command", false)) requests.push_back({Action::CopyCommand});
}

void Panels::drawSettingsTab(Requests& requests) {
  if (ui::flowButton("copy as command", true)) requests.push_back({Action::CopyCommand});
  panel_.searchableGroups();
}

void Panels::drawNumbers(const PanelInput& input) {
  const passes::FrameRenderer& renderer = input.renderer;
  const std::optional<double> rate = input.rate.perSecond();
  ui::nameValue(fmt::format("frame {}", input.events.index),
                rate ? fmt::format("{:.1f} frames a second", *rate) : std::string());
  drawMethodTimes(input);
  timeline_.draw();
  ImGui::Separator();
  drawFragments(input.result);
  ui::nameValue("every fragment shown", input.result.exact ? "yes" : "no",
                input.result.exact ? ui::Tone::Good : ui::Tone::Warning);
  if (input.result.lockFailures > 0) {
    ui::nameValue("locks given up", ui::countText(input.result.lockFailures), ui::Tone::Warning);
  }
  ImGui::Separator();
  const frame::ResourceBytes bytes = renderer.bytes();
  ui::nameValue("fragment storage", ui::bytesText(bytes.oit));
  if (renderer.plan().budgetBytes) {
    ui::nameValue("  budget", ui::bytesText(*renderer.plan().budgetBytes));
  }
  ui::nameValue("counts and maps", ui::bytesText(bytes.overhead));
  ui::nameValue("G-buffer", ui::bytesText(bytes.gbuffer));
  ui::nameValue("other images", ui::bytesText(bytes.other));
}

}  // namespace macula::tools
