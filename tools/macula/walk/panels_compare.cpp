// Panels: two methods against each other, and errors.
#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <string_view>

#include "engine/ui/legend.h"
#include "engine/ui/widgets.h"
#include "walk/panels.h"

namespace macula::tools {
namespace {

constexpr std::array<std::string_view, 4> kModeWords{"one", "split", "side by side", "difference"};
constexpr std::array<std::string_view, 3> kMapWords{"no map", "difference", "FLIP"};

void drawSecond(const PanelInput& input, Requests& requests) {
  SecondView& second = input.second;
  ImGui::PushID("second");
  ImGui::TextDisabled("method B, settings of its own");
  second.panel().row("oit.method");
  if (const passes::FrameRenderer* renderer = second.renderer()) {
    if (renderer->plan().method->hasBudget()) {
      second.panel().row("oit.kAve");
      second.panel().row("oit.tail");
    }
    const passes::FrameResult& b = second.result();
    drawMethodTimes(input);
    const auto lost = [](const passes::FrameResult& result) {
      return result.fragments ? ui::countText(result.fragments->lost) : std::string("not counted");
    };
    ui::nameValue("lost, A and B", fmt::format("{} and {}", lost(input.result), lost(b)));
  }
  if (second.mode() == ViewMode::Split) ui::note("Drag the line in the picture.");
  if (second.mode() == ViewMode::Difference) {
    ui::drawLegend(second.differenceLegend());
    if (ui::flowButton("amplify more (,)", true)) {
      requests.push_back({Action::ScaleDifference, "down"});
    }
    if (ui::flowButton("less (.)", false)) requests.push_back({Action::ScaleDifference, "up"});
  }
  if (!second.panel().refusal().empty()) {
    ui::note(second.panel().refusal(), ui::Tone::Error);
  }
  if (ImGui::TreeNode("all of B's transparency settings")) {
    constexpr std::array<std::string_view, 2> kOwn{"oit", "importance"};
    second.panel().searchableGroups(kOwn);
    ImGui::TreePop();
  }
  ImGui::PopID();
}

void drawResult(const PanelInput& input, Requests& requests) {
  const ErrorCheck& errors = input.errors;
  const ErrorCheck::Result& result = *errors.result();
  const measure::ImageError& error = result.error;
  ui::note(errors.title(input.scene.name), ui::Tone::Plain);
  // The picture and its times go on; these figures stay what they are.
  ui::note(
      fmt::format("{} ago; now at frame {}",
                  ui::numberOf(static_cast<unsigned>(input.events.index - result.frame), "frame"),
                  input.events.index));
  ui::nameValue("RMSE", fmt::format("{:.6f}", error.rmse));
  ui::nameValue(
      "PSNR", error.psnrDb ? fmt::format("{:.2f} dB", *error.psnrDb) : std::string("equal images"));
  ui::nameValue("largest", fmt::format("{:.4f}", error.max));
  if (error.flip) ui::nameValue("FLIP", fmt::format("{:.6f}", *error.flip));
  const auto shown = static_cast<std::size_t>(errors.map());
  if (const auto pressed = ui::chips(kMapWords, shown)) {
    requests.push_back({Action::ShowMap, mapNames()[*pressed]});
  }
  if (errors.map() == ErrorCheck::Map::Difference) {
    ui::note(error.max == 0.0 ? fmt::format("no difference, at frame {}", result.frame)
                              : fmt::format("|difference| of R, G, B times {:.4g}, at frame {}",
                                            result.differenceScale, result.frame));
  }
  if (errors.map() == ErrorCheck::Map::Flip) {
    ui::note(fmt::format("FLIP from 0 (black) to 1 (light yellow), at frame {}", result.frame));
  }
}

}  // namespace

void drawCompareTab(const PanelInput& input, Requests& requests) {
  SecondView& second = input.second;
  if (const auto pressed = ui::chips(kModeWords, static_cast<std::size_t>(second.mode()))) {
    requests.push_back({Action::View, viewModeNames()[*pressed]});
  }
  if (second.shown()) {
    ui::nameValue("method A", input.settings.oit.method);
    drawSecond(input, requests);
  } else {
    ui::note("Two methods in one window: A as on the view tab, B with settings of its own.");
  }
  ImGui::Separator();
  ImGui::TextDisabled("measure this view");
  ImGui::BeginDisabled(input.errors.busy());
  if (ui::flowButton("against the exact image (X)", true)) {
    requests.push_back({Action::Measure, "exact"});
  }
  if (second.shown() && ui::flowButton("against B", false)) {
    requests.push_back({Action::Measure, "second"});
  }
  ImGui::EndDisabled();
  if (input.errors.busy()) {
    ui::note("measuring ...", ui::Tone::Warning);
  } else if (input.errors.result()) {
    drawResult(input, requests);
  }
}

}  // namespace macula::tools
