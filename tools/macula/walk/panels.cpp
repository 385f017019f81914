#include "walk/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/nearest.h"
#include "engine/ui/key_table.h"
#include "engine/ui/widgets.h"
#include "passes/resources.h"
#include "walk/actions.h"
#include "walk/file_names.h"
#include "walk/gaze_cursor.h"

namespace macula::tools {
namespace {

/// Lengths of the layout in heights of the font, so that it follows the content scale.
constexpr float kMargin = 0.6F;
constexpr float kPanelWidth = 24.0F;
constexpr float kMessageWidth = 50.0F;
/// Narrower windows, in widths of a panel, begin with the numbers folded.
constexpr float kNarrow = 3.0F;
constexpr float kWidestShare = 0.45F;  ///< of the window for one panel

constexpr std::chrono::seconds kMessageTime{6};  ///< long enough to read a line

constexpr ImGuiWindowFlags kPanelFlags = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                         ImGuiWindowFlags_NoSavedSettings |
                                         ImGuiWindowFlags_NoFocusOnAppearing;

constexpr std::array<std::string_view, 9> kHints{"F1 panels",  "F2 keys",       "M method",
                                                 "H heat map", "B two methods", "X error",
                                                 "G gaze",     "P path",        "F12 picture"};

/// Windows of fewer lines show only how to find all keys.
constexpr float kLowLines = 26.0F;
constexpr std::size_t kHintsWhereLow = 2;

/// Items in as many lines as the width asks for, never cut within one.
std::string hintText(float width, std::size_t items) {
  constexpr const char* kGap = "    ";
  std::string text;
  std::string line;
  for (const std::string_view item : std::span(kHints).first(items)) {
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

/// Draws the most used keys in a bar over the whole width. @returns its height
float drawHints() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  const bool low = size.y < kLowLines * ImGui::GetFontSize();
  const std::string text =
      hintText(size.x - 2.0F * padding.x, low ? kHintsWhereLow : kHints.size());
  const float height = ImGui::CalcTextSize(text.c_str()).y + padding.y;
  ImGui::SetNextWindowPos({0.0F, size.y - height});
  ImGui::SetNextWindowSize({size.x, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padding.x, 0.5F * padding.y));
  // Shorter than what windows otherwise begin with.
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
  ImGui::Begin("hints", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings);
  ImGui::TextUnformatted(text.c_str());
  ImGui::End();
  ImGui::PopStyleVar(3);
  return height;
}

/// What is being recorded, at the lower left: seen with the panels and without them.
/// @param bottom of it. @returns its height
float drawRecordings(const std::vector<std::string>& recordings, float bottom) {
  if (recordings.empty()) return 0.0F;
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  const float line = ImGui::GetTextLineHeight();
  const float most = ImGui::GetIO().DisplaySize.x;
  const float radius = 0.3F * line;
  const float indent = 1.2F * line;  // the dot's place
  const float wrap = most - indent - 2.0F * padding.x;
  float width = 0.0F;
  float height = padding.y;
  for (const std::string& text : recordings) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    width = std::max(width, size.x);
    height += size.y;
  }
  const ImVec2 low(0.0F, bottom - height);
  ImGui::SetNextWindowPos(low);
  ImGui::SetNextWindowSize({std::min(width + indent + 2.0F * padding.x, most), height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padding.x, 0.5F * padding.y));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
  ImGui::Begin("recording", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings);
  for (const std::string& text : recordings) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + radius, at.y + 0.5F * line}, radius,
                                                IM_COL32(235, 60, 50, 255));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
    ui::note(text, ui::Tone::Plain);
  }
  ImGui::End();
  ImGui::PopStyleVar(4);
  return height;
}

std::vector<ui::KeyRow> helpRows() {
  std::vector<ui::KeyRow> rows;
  for (const ActionRow& row : actionRows()) rows.push_back({row.group, row.keyName, row.help});
  // Held keys steer the camera: they stand with its other keys.
  auto at = std::find_if(rows.begin(), rows.end(),
                         [](const ui::KeyRow& row) { return row.group == "Camera"; });
  std::vector<ui::KeyRow> held;
  for (const HeldKeyRow& row : heldKeyRows()) held.push_back({"Camera", row.keys, row.help});
  rows.insert(at, held.begin(), held.end());
  return rows;
}

}  // namespace

const std::vector<std::string>& tabNames() {
  static const std::vector<std::string> names{"view",   "scene",   "gaze",
                                              "camera", "compare", "settings"};
  return names;
}

Panels::Panels(settings::Registry& registry, bool shown, const std::string& tab)
    : panel_(registry), shown_(shown) {
  showTab(tab);
  shown_ = shown;
}

void Panels::showTab(const std::string& name) {
  const auto found = std::find(tabNames().begin(), tabNames().end(), name);
  if (found == tabNames().end()) {
    failInput("there is no tab '{}'; the nearest is '{}'", name, nearestName(name, tabNames()));
  }
  tab_ = static_cast<std::size_t>(found - tabNames().begin());
  if (name == "scene") listFolder(state_.folder);
  shown_ = true;
}

void Panels::search(const std::string& words) {
  showTab("settings");
  panel_.search(words);
  panel_.focusSearch();
}

bool Panels::close() {
  if (std::exchange(helpShown_, false)) return true;
  if (!panel_.hits()) return false;
  panel_.search("");
  return true;
}

void Panels::toggleNumbers() {
  numbersOpen_ = !numbersOpen_.value_or(true);
  numbersSet_ = true;
  shown_ = true;
}

void Panels::listFolder(const std::filesystem::path& folder) {
  state_.folder = folder.empty() ? "." : folder;
  state_.files = sceneFiles(state_.folder);
}

void Panels::add(const passes::FrameRenderer& renderer, const passes::FrameResult& result,
                 const FrameControl& control) {
  constexpr std::size_t kFrames = 240;  // as many as the plot of times has
  if (resizes_.size() == kFrames) resizes_.erase(resizes_.begin());
  resizes_.push_back(static_cast<float>(result.resizeFactor));
  if (control.settings().law == "off") resizes_.clear();
  rows_.clear();
  for (const frame::PassTime& pass : result.passes) rows_.push_back({pass.name, pass.ms});
  std::optional<ui::LayerRow> layers;
  if (result.layers) {
    layers = ui::LayerRow{
        static_cast<float>(result.layers->mean), static_cast<float>(result.layers->max), {}};
    const gl::Texture& image = renderer.resources().texture(passes::kHdrColor);
    if (renderer.plan().budgetBytes) {
      layers->budget = static_cast<float>(renderer.plan().slots) /
                       (static_cast<float>(image.width()) * static_cast<float>(image.height()));
    }
  }
  if (!result.timed) return;
  timeline_.add(rows_, result.totalMs, layers);
  time_.add(renderer.plan().method->id, result.totalMs);
}

void Panels::draw(const PanelInput& input, Requests& requests) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float em = ImGui::GetFontSize();
  const float margin = kMargin * em;
  footHeight_ = shown_ ? drawHints() : 0.0F;
  footHeight_ += drawRecordings(input.recordings, size.y - footHeight_);
  const float width = std::min(kPanelWidth * em, kWidestShare * size.x);
  const float bottom = std::min(size.y - footHeight_, input.bottom);
  const ImVec2 most(width, std::max(4.0F * em, bottom - 2.0F * margin));
  const ImGuiWindowFlags flags = kPanelFlags | ImGuiWindowFlags_AlwaysAutoResize;
  if (shown_) {
    ImGui::SetNextWindowPos({margin, margin});
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, most);
    if (ImGui::Begin("Macula", nullptr, flags)) drawTabs(input, requests);
    ImGui::End();

    if (!numbersOpen_) {
      numbersOpen_ = size.x >= kNarrow * width;
      numbersSet_ = true;
    }
    ImGui::SetNextWindowPos({size.x - margin - width, margin});
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, most);
    if (std::exchange(numbersSet_, false)) ImGui::SetNextWindowCollapsed(!*numbersOpen_);
    if (ImGui::Begin("Numbers", nullptr, flags)) drawNumbers(input);
    numbersOpen_ = !ImGui::IsWindowCollapsed();
    ImGui::End();
  }
  if (helpShown_) {
    static const std::vector<ui::KeyRow> rows = helpRows();
    helpShown_ = !ui::drawKeyTable(rows);
  }
}

void Panels::drawTabs(const PanelInput& input, Requests& requests) {
  static const std::vector<std::string_view> names(tabNames().begin(), tabNames().end());
  // Close together, so that they fit into one line.
  const ImGuiStyle& style = ImGui::GetStyle();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(0.75F * style.FramePadding.x, style.FramePadding.y));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                      ImVec2(0.5F * style.ItemSpacing.x, style.ItemSpacing.y));
  const std::optional<std::size_t> pressed = ui::chips(names, tab_);
  ImGui::PopStyleVar(2);
  if (pressed) showTab(tabNames()[*pressed]);
  ImGui::Separator();
  const std::string& open = tab();
  if (open == "view") drawViewTab(input, requests);
  if (open == "scene") drawSceneTab(input, state_, requests);
  if (open == "gaze") drawGazeTab(input, state_, requests);
  if (open == "camera") drawCameraTab(input, state_, requests);
  if (open == "compare") drawCompareTab(input, requests);
  if (open == "settings") drawSettingsTab(requests);
  if (!panel_.refusal().empty()) ui::note(panel_.refusal(), ui::Tone::Error);
}

void Panels::drawLoading(const SceneLoader& loader, bool small, Requests& requests) const {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float em = ImGui::GetFontSize();
  const float width = std::min(kPanelWidth * em, size.x - 2.0F * kMargin * em);
  ImGui::SetNextWindowPos({0.5F * size.x, 0.5F * size.y}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, size.y});
  ImGui::SetNextWindowBgAlpha(1.0F);
  if (ImGui::Begin("Loading", nullptr,
                   kPanelFlags | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize)) {
    ui::bringToFront();
    ui::note(loader.name(), ui::Tone::Plain);
    ui::nameValue(loader.stage(), fmt::format("{:.1f} s", loader.seconds()));
    // How long it takes is not known beforehand: a bar that wanders says that it goes on.
    constexpr double kTurnSeconds = 1.6;
    constexpr float kBarShare = 0.25F;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float length = ImGui::GetContentRegionAvail().x;
    const float height = 0.4F * em;
    const auto turn = static_cast<float>(std::fmod(loader.seconds(), kTurnSeconds) / kTurnSeconds);
    const float way = (1.0F - kBarShare) * length * (1.0F - std::abs(2.0F * turn - 1.0F));
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(low, {low.x + length, low.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                        0.5F * height);
    list->AddRectFilled({low.x + way, low.y}, {low.x + way + kBarShare * length, low.y + height},
                        ImGui::GetColorU32(ImGuiCol_PlotHistogram), 0.5F * height);
    ImGui::Dummy({length, height});
    if (ImGui::Button(small ? "cancel (Esc)" : "close (Esc)")) requests.push_back({Action::Close});
  }
  ImGui::End();
}

bool Panels::drawMessage(const Message* message, float bottom) const {
  if (message == nullptr) return false;
  if (!message->error && std::chrono::steady_clock::now() - message->since > kMessageTime) {
    return true;
  }
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float em = ImGui::GetFontSize();
  const float width = std::min(kMessageWidth * em, size.x - 2.0F * kMargin * em);
  ImGui::SetNextWindowPos({0.5F * size.x, bottom}, ImGuiCond_Always, {0.5F, 1.0F});
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {width, bottom});
  ImGui::SetNextWindowBgAlpha(1.0F);
  ImGui::Begin("message", nullptr,
               kPanelFlags | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_AlwaysAutoResize);
  ui::bringToFront();
  const float wrap = width - 2.0F * ImGui::GetStyle().WindowPadding.x;
  ImGui::PushTextWrapPos(wrap);
  ImGui::PushStyleColor(ImGuiCol_Text, message->error ? ImVec4(1.0F, 0.65F, 0.55F, 1.0F)
                                                      : ImGui::GetStyleColorVec4(ImGuiCol_Text));
  ImGui::TextUnformatted(message->text.c_str());
  ImGui::PopStyleColor();
  if (message->error) ImGui::TextDisabled("click to close");
  ImGui::PopTextWrapPos();
  const bool clicked = ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  ImGui::End();
  return clicked;
}

}  // namespace macula::tools
