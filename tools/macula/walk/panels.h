// The panels of a walk: what is drawn where, from the settings and the numbers of the last frame.
#pragma once

#include <chrono>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/ui/frame_rate.h"
#include "engine/ui/settings_panel.h"
#include "engine/ui/timeline.h"
#include "frame_control.h"
#include "passes/frame_renderer.h"
#include "walk/camera_control.h"
#include "walk/error_check.h"
#include "walk/frame_events.h"
#include "walk/gaze_control.h"
#include "walk/request.h"
#include "walk/scene_loader.h"
#include "walk/second_view.h"

namespace macula::tools {

/// "view", "scene", ... as --panel takes them, in the order in which they stand.
[[nodiscard]] const std::vector<std::string>& tabNames();

/// Words for the user, shown until they are read.
struct Message {
  std::string text;
  bool error = false;
  std::chrono::steady_clock::time_point since;
};

/// What the panels show; they change it only through requests and settings.
struct PanelInput {
  const FrameEvents& events;
  const passes::FrameRenderer& renderer;
  const passes::FrameResult& result;
  const passes::RenderSettings& settings;
  const ShownScene& scene;
  const CameraControl& camera;
  GazeControl& gaze;
  SecondView& second;
  const ErrorCheck& errors;
  const FrameControl& control;
  const ui::FrameRate& rate;
  const ui::MethodTime& time;                  ///< of method A
  const std::vector<std::string>& recordings;  ///< what is being recorded, a line each
  float bottom = 0.0F;  ///< no panel reaches below it, in the UI's coordinates: labels stand there
};

/// What is typed and listed on the tabs, from frame to frame.
struct TabState {
  std::string sceneField;
  std::string gazeField;
  std::string pathField;
  std::string pictureField;
  int layers = 64;
  int medley = 0;
  std::filesystem::path folder = ".";
  std::vector<std::filesystem::path> files;
};

class Panels {
 public:
  Panels(settings::Registry& registry, bool shown, const std::string& tab);

  /// Takes the numbers of a frame, once they are there.
  void add(const passes::FrameRenderer& renderer, const passes::FrameResult& result,
           const FrameControl& control);
  /// Draws the gaze, the panels and the help page. Between the frames of the UI.
  void draw(const PanelInput& input, Requests& requests);
  /// What is loading, in the middle of an empty window or small over the picture.
  void drawLoading(const SceneLoader& loader, bool small, Requests& requests) const;
  /// @param message null where there is none
  /// @param bottom of its box, in the UI's coordinates
  /// @returns whether it was clicked away
  [[nodiscard]] bool drawMessage(const Message* message, float bottom) const;

  void toggle() { shown_ = !shown_; }
  void toggleHelp() { helpShown_ = !helpShown_; }
  void toggleNumbers();
  /// @throws InputError where there is no such tab
  void showTab(const std::string& name);
  void search(const std::string& words);
  /// Closes the help page or ends a search. @returns whether there was one
  [[nodiscard]] bool close();
  /// Lists the scene files of a folder.
  void listFolder(const std::filesystem::path& folder);
  /// Scene files of that folder.
  [[nodiscard]] std::size_t listed() const { return state_.files.size(); }

  [[nodiscard]] ui::SettingsPanel& settings() { return panel_; }
  [[nodiscard]] const std::string& tab() const { return tabNames()[tab_]; }
  [[nodiscard]] bool shown() const { return shown_; }
  /// Whether numbers of frames can be seen: times, counts.
  [[nodiscard]] bool numbersShown() const {
    return shown_ && (numbersOpen_.value_or(true) || tab() == "compare");
  }
  [[nodiscard]] bool helpShown() const { return helpShown_; }
  /// Of method A.
  [[nodiscard]] const ui::MethodTime& time() const { return time_; }
  /// Height of what stands along the lower edge, in the UI's coordinates: nothing else may be
  /// there.
  [[nodiscard]] float footHeight() const { return footHeight_; }

 private:
  void drawTabs(const PanelInput& input, Requests& requests);
  void drawNumbers(const PanelInput& input);
  void drawControl(const PanelInput& input);
  void drawViewTab(const PanelInput& input, Requests& requests);
  void drawSettingsTab(Requests& requests);

  ui::SettingsPanel panel_;
  ui::Timeline timeline_;
  ui::MethodTime time_;
  std::vector<ui::TimeRow> rows_;  ///< of the newest frame; kept for its memory
  std::vector<float> resizes_;     ///< r of the last frames where a law chooses it, the newest last
  TabState state_;
  std::size_t tab_ = 0;
  float footHeight_ = 0.0F;
  bool shown_;
  bool helpShown_ = false;
  std::optional<bool> numbersOpen_;  ///< none: as the window's width suggests
  bool numbersSet_ = false;          ///< numbersOpen_ is to be applied
};

// Tabs that need no settings panel.
void drawSceneTab(const PanelInput& input, TabState& state, Requests& requests);
void drawGazeTab(const PanelInput& input, TabState& state, Requests& requests);
void drawCameraTab(const PanelInput& input, TabState& state, Requests& requests);
void drawCompareTab(const PanelInput& input, Requests& requests);

/// The median frame time of each method that is shown, by its name.
void drawMethodTimes(const PanelInput& input);

}  // namespace macula::tools
