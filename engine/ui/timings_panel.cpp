#include "engine/ui/timings_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace macula::ui {
namespace {

/// The table's times follow a change within about this long, however long a frame takes.
constexpr double kSmoothingMs = 500.0;

constexpr float kPlotLines = 4.5F;  ///< height of the plot in lines of text

}  // namespace

void TimingsPanel::add(std::span<const TimeRow> passes, double totalMs) {
  const double newest = 1.0 - std::exp(-totalMs / kSmoothingMs);
  std::vector<Smoothed> smoothed;
  smoothed.reserve(passes.size());
  for (const TimeRow& pass : passes) {
    const auto old = std::find_if(passes_.begin(), passes_.end(),
                                  [&](const Smoothed& row) { return row.name == pass.name; });
    const double ms = old == passes_.end() ? pass.ms : old->ms + newest * (pass.ms - old->ms);
    smoothed.push_back({std::string(pass.name), ms});
  }
  passes_ = std::move(smoothed);
  totals_[next_] = static_cast<float>(totalMs);
  next_ = (next_ + 1) % kHistory;
  count_ = std::min(count_ + 1, kHistory);
}

double TimingsPanel::medianMs() const {
  if (count_ == 0) return 0.0;
  // Until the ring is full its first count_ places are in use, afterwards all.
  std::array<float, kHistory> sorted = totals_;
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(count_ / 2);
  std::nth_element(sorted.begin(), middle, end);
  return static_cast<double>(*middle);
}

void TimingsPanel::draw() const {
  drawPlot();
  drawTable();
}

void TimingsPanel::drawPlot() const {
  const auto used = static_cast<std::ptrdiff_t>(count_);
  const float largest =
      count_ == 0 ? 0.0F : *std::max_element(totals_.begin(), totals_.begin() + used);
  const double median = medianMs();
  constexpr double kMsPerSecond = 1000.0;
  ImGui::Text("frame %.1f ms (%.3g per second)", median,
              median > 0.0 ? kMsPerSecond / median : 0.0);
  const bool full = count_ == kHistory;
  ImGui::PlotLines("##frames", totals_.data(), static_cast<int>(count_),
                   full ? static_cast<int>(next_) : 0, nullptr, 0.0F,
                   std::max(largest, FLT_MIN) * 1.1F,
                   {ImGui::GetContentRegionAvail().x, kPlotLines * ImGui::GetTextLineHeight()});
  const std::string right = fmt::format("longest {:.1f} ms", static_cast<double>(largest));
  ImGui::TextDisabled("last %d frames", static_cast<int>(count_));
  ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(right.c_str()).x +
                  ImGui::GetStyle().WindowPadding.x);
  ImGui::TextDisabled("%s", right.c_str());
}

void TimingsPanel::drawTable() const {
  double longest = 0.0;
  for (const Smoothed& pass : passes_) longest = std::max(longest, pass.ms);
  if (!ImGui::BeginTable("passes", 3, ImGuiTableFlags_SizingFixedFit)) return;
  ImGui::TableSetupColumn("pass");
  ImGui::TableSetupColumn("ms");
  ImGui::TableSetupColumn("bar", ImGuiTableColumnFlags_WidthStretch);
  for (const Smoothed& pass : passes_) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(pass.name.c_str());
    ImGui::TableNextColumn();
    ImGui::Text("%7.2f", pass.ms);
    ImGui::TableNextColumn();
    const double share = longest > 0.0 ? pass.ms / longest : 0.0;
    ImGui::ProgressBar(static_cast<float>(share), {-FLT_MIN, ImGui::GetTextLineHeight()}, "");
  }
  ImGui::EndTable();
}

}  // namespace macula::ui
