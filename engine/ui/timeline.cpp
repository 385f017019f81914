#include "engine/ui/timeline.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdio>

#include "engine/ui/widgets.h"

namespace macula::ui {
namespace {

/// The table's times follow a change within about this long, however long a frame takes.
constexpr double kSmoothingMs = 500.0;

constexpr float kTimesLines = 6.0F;  ///< heights of the plots in lines of text
constexpr float kLayersLines = 3.0F;
constexpr float kHeadroom = 1.1F;  ///< of a plot over its largest value

/// Colours that stay apart side by side, in the order in which passes are first seen; after the
/// "tableau 20" list (M. Stone 2016), light and dark in turn.
constexpr std::array<ImU32, 12> kColors{
    IM_COL32(78, 121, 167, 255),  IM_COL32(242, 142, 43, 255),  IM_COL32(89, 161, 79, 255),
    IM_COL32(225, 87, 89, 255),   IM_COL32(118, 183, 178, 255), IM_COL32(237, 201, 72, 255),
    IM_COL32(176, 122, 161, 255), IM_COL32(255, 157, 167, 255), IM_COL32(156, 117, 95, 255),
    IM_COL32(160, 203, 232, 255), IM_COL32(140, 209, 125, 255), IM_COL32(186, 176, 172, 255)};
constexpr ImU32 kBudgetColor = IM_COL32(255, 255, 255, 150);
constexpr ImU32 kMeanColor = IM_COL32(115, 200, 242, 255);
constexpr ImU32 kMostColor = IM_COL32(242, 142, 43, 255);

ImU32 colorOf(std::size_t pass) {
  return kColors[pass % kColors.size()];
}

/// The place of a plot, framed and reserved in the current window.
struct PlotArea {
  ImVec2 low;
  ImVec2 size;
  bool hovered = false;

  PlotArea(const char* id, float lines)
      : low(ImGui::GetCursorScreenPos()),
        size(ImGui::GetContentRegionAvail().x, lines * ImGui::GetTextLineHeight()) {
    ImGui::InvisibleButton(id, size);
    hovered = ImGui::IsItemHovered();
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + size.x, low.y + size.y},
                                              ImGui::GetColorU32(ImGuiCol_FrameBg));
  }
  [[nodiscard]] float bottom() const { return low.y + size.y; }
};

void swatch(ImU32 color) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = ImGui::GetTextLineHeight();
  const float inset = 0.2F * side;
  ImGui::GetWindowDrawList()->AddRectFilled({at.x + inset, at.y + inset},
                                            {at.x + side - inset, at.y + side - inset}, color);
  ImGui::Dummy({side, side});
  ImGui::SameLine(0.0F, 0.0F);
}

}  // namespace

std::size_t Timeline::indexOf(std::string_view name) {
  const auto found = std::find_if(passes_.begin(), passes_.end(),
                                  [&](const PassRow& row) { return row.name == name; });
  if (found != passes_.end()) return static_cast<std::size_t>(found - passes_.begin());
  if (passes_.size() + 1 >= kPasses) name = "other";
  if (passes_.size() >= kPasses) return kPasses - 1;
  passes_.push_back({std::string(name)});
  return passes_.size() - 1;
}

void Timeline::add(std::span<const TimeRow> passes, double totalMs,
                   const std::optional<LayerRow>& layers) {
  Frame& frame = frames_[next_];
  frame = {};
  frame.totalMs = static_cast<float>(totalMs);
  frame.layers = layers;
  for (PassRow& row : passes_) row.runs = false;
  for (const TimeRow& pass : passes) {
    const std::size_t index = indexOf(pass.name);
    frame.ms[index] += static_cast<float>(pass.ms);
    passes_[index].runs = true;
  }
  const double newest = 1.0 - std::exp(-totalMs / kSmoothingMs);
  for (std::size_t i = 0; i < passes_.size(); ++i) {
    double& smoothed = passes_[i].smoothedMs;
    const double ms = static_cast<double>(frame.ms[i]);
    smoothed = smoothed > 0.0 ? smoothed + newest * (ms - smoothed) : ms;
  }
  next_ = (next_ + 1) % kHistory;
  count_ = std::min(count_ + 1, kHistory);
}

const Timeline::Frame& Timeline::frameAt(std::size_t age) const {
  return frames_[(next_ + kHistory - 1 - age) % kHistory];
}

void Timeline::draw() const {
  drawTimes();
  drawLayers();
  drawTable();
}

void Timeline::drawTimes() const {
  float longest = 0.0F;
  for (std::size_t age = 0; age < count_; ++age) {
    longest = std::max(longest, frameAt(age).totalMs);
  }
  const PlotArea area("##times", kTimesLines);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float column = area.size.x / static_cast<float>(kHistory);
  const float scale = area.size.y / (kHeadroom * std::max(longest, FLT_MIN));
  for (std::size_t age = 0; age < count_; ++age) {
    const Frame& frame = frameAt(age);
    const float right = area.low.x + area.size.x - column * static_cast<float>(age);
    // What no pass accounts for lies behind the stack, in grey.
    list->AddRectFilled({right - column, area.bottom() - scale * frame.totalMs},
                        {right, area.bottom()}, IM_COL32(110, 112, 118, 255));
    float top = area.bottom();
    for (std::size_t pass = 0; pass < passes_.size(); ++pass) {
      if (frame.ms[pass] <= 0.0F) continue;
      const float below = top;
      top -= scale * frame.ms[pass];
      list->AddRectFilled({right - column, top}, {right, below}, colorOf(pass));
    }
  }
  // The scale, over the bars.
  std::array<char, 32> label{};
  std::snprintf(label.data(), label.size(), "%.1f ms", static_cast<double>(longest));
  const float top = area.bottom() - scale * longest;
  list->AddLine({area.low.x, top}, {area.low.x + area.size.x, top}, IM_COL32(255, 255, 255, 60));
  list->AddText({area.low.x + 2.0F, top}, IM_COL32(255, 255, 255, 200), label.data());
  if (!area.hovered || count_ == 0) return;
  const float fromRight = area.low.x + area.size.x - ImGui::GetIO().MousePos.x;
  const auto age = static_cast<std::size_t>(std::max(0.0F, fromRight / column));
  if (age >= count_) return;
  const float x = area.low.x + area.size.x - column * (static_cast<float>(age) + 0.5F);
  list->AddLine({x, area.low.y}, {x, area.bottom()}, IM_COL32(255, 255, 255, 160));
  drawTooltip(frameAt(age), age);
}

void Timeline::drawTooltip(const Frame& frame, std::size_t age) const {
  ImGui::BeginTooltip();
  ImGui::Text("%s ago: %.2f ms", numberOf(age, "frame").c_str(),
              static_cast<double>(frame.totalMs));
  for (std::size_t pass = 0; pass < passes_.size(); ++pass) {
    if (frame.ms[pass] <= 0.0F) continue;
    swatch(colorOf(pass));
    ImGui::Text("%7.2f  %s", static_cast<double>(frame.ms[pass]), passes_[pass].name.c_str());
  }
  if (frame.layers) {
    ImGui::Text("k mean %.2f, most %.0f", static_cast<double>(frame.layers->mean),
                static_cast<double>(frame.layers->most));
    if (frame.layers->budget) {
      ImGui::Text("budget %.2f a sample", static_cast<double>(*frame.layers->budget));
    }
  }
  ImGui::EndTooltip();
}

void Timeline::drawLayers() const {
  float largest = 0.0F;
  for (std::size_t age = 0; age < count_; ++age) {
    if (const auto& layers = frameAt(age).layers) {
      largest = std::max({largest, layers->most, layers->budget.value_or(0.0F)});
    }
  }
  if (largest <= 0.0F) return;
  const PlotArea area("##layers", kLayersLines);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float column = area.size.x / static_cast<float>(kHistory);
  // Square roots, so that a mean of 3 can be read beside a maximum of 100.
  const auto heightOf = [&](float k) {
    return area.bottom() - area.size.y * std::sqrt(k / (kHeadroom * largest));
  };
  const auto plot = [&](float a, float b, float right, ImU32 color) {
    list->AddLine({right - 1.5F * column, heightOf(a)}, {right - 0.5F * column, heightOf(b)}, color,
                  1.5F);
  };
  for (std::size_t age = 0; age + 1 < count_; ++age) {
    const auto& newer = frameAt(age).layers;
    const auto& older = frameAt(age + 1).layers;
    if (!newer || !older) continue;
    const float right = area.low.x + area.size.x - column * static_cast<float>(age);
    plot(older->most, newer->most, right, kMostColor);
    plot(older->mean, newer->mean, right, kMeanColor);
    if (newer->budget && older->budget) plot(*older->budget, *newer->budget, right, kBudgetColor);
  }
  const auto& newest = frameAt(0).layers;
  swatch(kMeanColor);
  ImGui::Text("mean k %.2f", newest ? static_cast<double>(newest->mean) : 0.0);
  ImGui::SameLine();
  swatch(kMostColor);
  ImGui::Text("most %.0f", newest ? static_cast<double>(newest->most) : 0.0);
  if (newest && newest->budget) {
    ImGui::SameLine();
    swatch(kBudgetColor);
    ImGui::Text("budget %.2f", static_cast<double>(*newest->budget));
  }
  if (!area.hovered) return;
  const float fromRight = area.low.x + area.size.x - ImGui::GetIO().MousePos.x;
  const auto age = static_cast<std::size_t>(std::max(0.0F, fromRight / column));
  if (age < count_) drawTooltip(frameAt(age), age);
}

void Timeline::drawTable() const {
  double longest = 0.0;
  for (const PassRow& row : passes_) longest = std::max(longest, row.runs ? row.smoothedMs : 0.0);
  if (!ImGui::BeginTable("passes", 3, ImGuiTableFlags_SizingFixedFit)) return;
  ImGui::TableSetupColumn("pass");
  ImGui::TableSetupColumn("ms");
  ImGui::TableSetupColumn("bar", ImGuiTableColumnFlags_WidthStretch);
  for (std::size_t i = 0; i < passes_.size(); ++i) {
    const PassRow& row = passes_[i];
    if (!row.runs) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    swatch(colorOf(i));
    ImGui::TextUnformatted(row.name.c_str());
    ImGui::TableNextColumn();
    ImGui::Text("%7.2f", row.smoothedMs);
    ImGui::TableNextColumn();
    const double share = longest > 0.0 ? row.smoothedMs / longest : 0.0;
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, colorOf(i));
    ImGui::ProgressBar(static_cast<float>(share), {-FLT_MIN, ImGui::GetTextLineHeight()}, "");
    ImGui::PopStyleColor();
  }
  ImGui::EndTable();
}

}  // namespace macula::ui
