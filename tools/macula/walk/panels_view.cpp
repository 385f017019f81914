// Panels: the view and settings tabs, and the numbers.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <string_view>

#include "engine/ui/legend.h"
#include "engine/ui/widgets.h"
#include "frame_record.h"
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

/// A value as it is read at a glance.
std::string textOf(const measure::Metric& metric, const measure::Value& value) {
  constexpr double kPercent = 100.0;
  if (const auto* const text = std::get_if<std::string>(&value)) return *text;
  if (const auto* const flag = std::get_if<bool>(&value)) return *flag ? "yes" : "no";
  if (const auto* const count = std::get_if<std::uint64_t>(&value)) {
    return metric.unit == "bytes" ? ui::bytesText(*count) : ui::countText(*count);
  }
  const double number = std::get<double>(value);
  if (metric.unit == "share") return fmt::format("{:.1f} %", kPercent * number);
  if (metric.unit == "ms") return fmt::format("{:.1f} ms", number);
  return fmt::format("{:.2f}", number);
}

/// A flag that should be set, and a count that should be 0, are marked.
ui::Tone toneOf(const measure::Metric& metric, const measure::Value& value) {
  const auto* const flag = std::get_if<bool>(&value);
  if (flag != nullptr && metric.better == measure::Better::Higher) {
    return *flag ? ui::Tone::Good : ui::Tone::Warning;
  }
  const auto* const count = std::get_if<std::uint64_t>(&value);
  const bool fault = metric.better == measure::Better::Lower && metric.unit != "bytes";
  return count != nullptr && fault && *count > 0 ? ui::Tone::Warning : ui::Tone::Plain;
}

/// The metrics of the frame that are for a walk. Where a level of names has no values, why.
void drawMetrics(const measure::FrameRecord& record) {
  std::string_view before;
  for (std::size_t row = 0; row < measure::kMetrics.size(); ++row) {
    const measure::Metric& metric = measure::kMetrics[row];
    if (!metric.in(measure::kWalk)) continue;
    const std::string_view level = metric.name.substr(0, metric.name.find('.'));
    const bool first = level != before && level != metric.name;
    before = level;
    const measure::Value& value = record.at(row);
    if (value.index() > 0) {
      ui::nameValue(metric.title, textOf(metric, value), toneOf(metric, value));
    } else if (first) {
      ui::nameValue(metric.title, metric.none, ui::Tone::Quiet);
    }
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
  using control::QualityControl;
  panel_.row("control.targetMs");
  const control::Controller& controller = input.control.controller();
  ui::nameValue("r", fmt::format("{:.3f}", input.result.resizeFactor));
  const control::ControlValues& controls = controller.controls();
  if (controls[QualityControl::FoveaSlope] != 1.0 || controls[QualityControl::LayerShare] != 1.0) {
    ui::nameValue("fovea's slope, layers",
                  fmt::format("x {:.2f}, x {:.2f}", controls[QualityControl::FoveaSlope],
                              controls[QualityControl::LayerShare]));
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
  const std::optional<double> rate = input.rate.perSecond();
  ui::nameValue(fmt::format("frame {}", input.events.index),
                rate ? fmt::format("{:.1f} frames a second", *rate) : std::string());
  drawMethodTimes(input);
  timeline_.draw();
  ImGui::Separator();
  drawMetrics(recordOf(input.renderer, input.result));
}

}  // namespace macula::tools
