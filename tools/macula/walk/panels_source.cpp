// Panels: the tabs that say what is shown and who looks at it: scene, gaze, camera.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "engine/core/plural.h"
#include "engine/scene/load.h"
#include "engine/ui/widgets.h"
#include "walk/file_names.h"
#include "walk/gaze_cursor.h"
#include "walk/panels.h"

namespace macula::tools {
namespace {

constexpr double kPercent = 100.0;

/// A field for a path, with a button. @returns whether something was entered; that nothing was is
/// said, too
bool pathField(const char* id, const char* hint, const char* button, std::string& text,
               Requests& requests) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float buttonWidth = ImGui::CalcTextSize(button).x + 2.0F * style.FramePadding.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - buttonWidth - style.ItemSpacing.x);
  bool entered = ImGui::InputTextWithHint(id, hint, &text, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  ImGui::PushID(id);
  entered = ImGui::Button(button) || entered;
  ImGui::PopID();
  if (entered && text.empty()) {
    requests.push_back({Action::Refuse, fmt::format("the field is empty; type a {}", hint)});
  }
  return entered && !text.empty();
}

/// A family of scenes: a field for the number of one, and a button.
void drawNumbered(const char* prefix, int least, int most, int& number, Requests& requests) {
  constexpr float kFieldEms = 6.0F;
  ImGui::PushID(prefix);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(prefix);
  ImGui::SameLine(0.0F, 0.0F);
  ImGui::SetNextItemWidth(kFieldEms * ImGui::GetFontSize());
  ImGui::DragInt("##number", &number, 1.0F, least, most, "%d", ImGuiSliderFlags_AlwaysClamp);
  ImGui::SameLine();
  if (ImGui::Button("show")) {
    requests.push_back({Action::LoadScene, fmt::format("{}{}", prefix, number)});
  }
  ImGui::PopID();
}

void drawRecipes(const PanelInput& input, TabState& state, Requests& requests) {
  static const std::vector<scene::RecipeInfo> recipes = scene::recipes();
  for (const scene::RecipeInfo& recipe : recipes) {
    if (recipe.name.ends_with("-N")) continue;
    if (ImGui::Selectable(recipe.name.c_str(), recipe.name == input.scene.name)) {
      requests.push_back({Action::LoadScene, recipe.name});
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", recipe.description.c_str());
  }
  constexpr int kMostLayers = 4096;
  constexpr int kMostMedley = 9999;
  drawNumbered("layers-", 1, kMostLayers, state.layers, requests);
  drawNumbered("medley-", 0, kMostMedley, state.medley, requests);
}

/// The states of the last frames as a strip of colours, the newest at the right.
void drawStrip(const GazeControl& gaze) {
  constexpr float kHeightEms = 0.5F;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, kHeightEms * ImGui::GetFontSize());
  const float column = size.x / static_cast<float>(GazeControl::kStrip);
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (std::size_t ago = 0; ago < GazeControl::kStrip; ++ago) {
    const float right = low.x + size.x - column * static_cast<float>(ago);
    list->AddRectFilled({right - column, low.y}, {right, low.y + size.y},
                        colorOf(gaze.stateAgo(ago)));
  }
  ImGui::Dummy(size);
}

void drawRecording(const GazeControl& gaze) {
  const GazeControl::Recording& recording = *gaze.recording();
  const gaze::GazeQuality& quality = recording.quality;
  const double duration = quality.durationSeconds;
  const double played = std::min(gaze.sourceSeconds(), duration);
  const std::string text = gaze.sourceSeconds() > duration
                               ? std::string("ended")
                               : fmt::format("{:.1f} of {:.1f} s", played, duration);
  ImGui::ProgressBar(static_cast<float>(duration > 0.0 ? played / duration : 1.0),
                     {ImGui::GetContentRegionAvail().x, 0.0F}, text.c_str());
  ui::nameValue("format", recording.format);
  for (const std::string& warning : recording.warnings) ui::note(warning, ui::Tone::Warning);
  ui::nameValue("samples",
                fmt::format("{} at {:.1f} Hz", ui::countText(quality.samples), quality.rateHz));
  const double samples = static_cast<double>(std::max<std::size_t>(1, quality.samples));
  ui::nameValue("lost in the log",
                fmt::format("{:.1f} %", kPercent * static_cast<double>(quality.lost) / samples));
  ui::nameValue("longest dropout", fmt::format("{:.3f} s", quality.longestDropoutSeconds));
}

void drawStatus(const PanelInput& input) {
  const gaze::PointOfInterest& point = input.events.gaze;
  const gaze::SourceStatus status = input.gaze.status();
  ImGui::TextUnformatted("state");
  ImGui::SameLine();
  ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colorOf(point.state)), "%s",
                     std::string(gaze::stateName(point.state)).c_str());
  ImGui::SameLine();
  ImGui::TextDisabled("last %d frames:", static_cast<int>(GazeControl::kStrip));
  drawStrip(input.gaze);
  ui::nameValue("place", fmt::format("{:.3f}, {:.3f}", point.position.x, point.position.y));
  ui::nameValue("age",
                std::isfinite(point.ageSeconds)
                    ? fmt::format("{:.0f} ms", 1000.0 * static_cast<double>(point.ageSeconds))
                    : std::string("no gaze yet"));
  ui::nameValue("fovea's radius", fmt::format("{:.1f} % of the height",
                                              kPercent * static_cast<double>(point.radius)));
  if (status.rateHz > 0.0) {
    ui::nameValue("rate", fmt::format("{:.1f} Hz", status.rateHz));
    ui::nameValue("lost lately", fmt::format("{:.1f} %", kPercent * status.lostShare));
  }
  if (status.clock) {
    ui::nameValue("its clock", fmt::format("{:+.1f} ppm, within {:.2f} ms", status.clock->driftPpm,
                                           1e3 * status.clock->residualSeconds));
  }
  if (!status.connected) ui::note("the device is away", ui::Tone::Error);
  if (!status.message.empty()) ui::note(status.message, ui::Tone::Warning);
}

}  // namespace

void drawSceneTab(const PanelInput& input, TabState& state, Requests& requests) {
  ui::note(input.scene.name, ui::Tone::Plain);
  ui::note(input.scene.facts);
  for (const std::string& warning : input.scene.warnings) ui::note(warning, ui::Tone::Warning);
  ImGui::Separator();
  drawRecipes(input, state, requests);
  ImGui::Separator();
  std::error_code error;
  const auto folder = std::filesystem::weakly_canonical(state.folder, error);
  ui::note(fmt::format(
      "{}: {}", folder.string(),
      state.files.empty() ? "no .glb or .gltf" : ui::numberOf(state.files.size(), "scene file")));
  for (const std::filesystem::path& file : state.files) {
    if (ImGui::Selectable(file.filename().c_str(), file.string() == input.scene.name)) {
      requests.push_back({Action::LoadScene, file.string()});
    }
  }
  if (pathField("##scene", "file, folder or name", "open", state.sceneField, requests)) {
    requests.push_back({Action::Drop, state.sceneField});
  }
  ui::note("or drop a .glb or .gltf file on the window");
}

void drawGazeTab(const PanelInput& input, TabState& state, Requests& requests) {
  GazeControl& gaze = input.gaze;
  for (const GazeChoice& choice : gaze.choices()) {
    if (ImGui::Selectable(choice.spec.c_str(), choice.spec == gaze.spec())) {
      requests.push_back({Action::GazeSource, choice.spec});
    }
    if (!choice.note.empty() && ImGui::IsItemHovered()) {
      ImGui::SetTooltip("%s", choice.note.c_str());
    }
  }
  if (pathField("##gaze", "log file, place x,y or hid", "open", state.gazeField, requests)) {
    requests.push_back({Action::GazeSource, state.gazeField});
  }
  ui::note("or drop a gaze log on the window");
  if (!gaze.opening().empty()) ui::note("opening " + gaze.opening(), ui::Tone::Warning);
  ImGui::Separator();
  ui::nameValue("source", gaze.spec());
  drawStatus(input);
  if (gaze.recording()) drawRecording(gaze);
  bool shown = gaze.cursorShown;
  if (ImGui::Checkbox("gaze and fovea drawn (V)", &shown)) {
    requests.push_back({Action::ToggleCursor});
  }
}

void drawCameraTab(const PanelInput& input, TabState& state, Requests& requests) {
  const CameraControl& camera = input.camera;
  const scene::Camera& now = input.events.camera;
  const glm::vec3 ahead = glm::normalize(now.target - now.position);
  ui::nameValue("place", fmt::format("{:.3f}, {:.3f}, {:.3f} m", now.position.x, now.position.y,
                                     now.position.z));
  ui::nameValue("looks along", fmt::format("{:.3f}, {:.3f}, {:.3f}", ahead.x, ahead.y, ahead.z));
  ui::nameValue("speed (wheel)", fmt::format("{:.2f}", camera.speed()));
  if (ui::flowButton("back to the start (R)", true)) requests.push_back({Action::ResetCamera});
  ImGui::Separator();
  if (camera.playing()) {
    const double length = camera.pathSeconds();
    const double time = length > 0.0 ? std::fmod(camera.playedSeconds(), length) : 0.0;
    ImGui::ProgressBar(static_cast<float>(length > 0.0 ? time / length : 0.0),
                       {ImGui::GetContentRegionAvail().x, 0.0F},
                       fmt::format("{:.1f} of {:.1f} s", time, length).c_str());
    ui::nameValue("plays", camera.pathName());
    if (ui::flowButton("stop (P)", true)) requests.push_back({Action::PlayPath});
  } else {
    if (ui::flowButton("play the orbit", true)) requests.push_back({Action::PlayPath, "auto"});
    if (camera.pathName() != "auto" && ui::flowButton("play the path (P)", false)) {
      requests.push_back({Action::PlayPath, camera.pathName()});
    }
  }
  if (pathField("##path", "path file (CSV)", "play", state.pathField, requests)) {
    requests.push_back({Action::PlayPath, state.pathField});
  }
  ImGui::Separator();
  if (camera.recording()) {
    ui::nameValue("recording",
                  fmt::format("{:.1f} s, {}", camera.recordedSeconds(),
                              ui::numberOf(camera.recordedKeys(), "key")),
                  ui::Tone::Error);
  }
  if (ui::flowButton(camera.recording() ? "end and save (L)" : "record a path (L)", true)) {
    requests.push_back({Action::RecordPath});
  }
  ui::note("Saved as camera_001.csv, ...; 'macula replay --camera' takes it too.");
}

}  // namespace macula::tools
