// A walk from the opening of the window to its end.
#pragma once

#include <chrono>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "engine/gaze/source.h"
#include "engine/scene/gpu_scene.h"
#include "engine/ui/ui_context.h"
#include "engine/window/window.h"
#include "passes/frame_renderer.h"
#include "passes/machine.h"
#include "walk_camera.h"
#include "walk_options.h"
#include "walk_panels.h"
#include "walk_recorder.h"
#include "walk_screen.h"

namespace macula::tools {

class WalkSession {
 public:
  /// @param window its context is current
  /// @param start the camera to begin with
  /// @param probes places whose k is reported, 0..1 of the window from the top left
  WalkSession(WalkOptions& options, window::Window& window, const scene::GpuScene& gpu,
              const scene::Camera& start, std::vector<glm::vec2> probes);
  /// Draws frames until the window is closed or the frames of the options are drawn.
  void run();

 private:
  using Clock = std::chrono::steady_clock;

  void frame();
  void readKeys();
  void steer(float seconds);
  void lookAround(bool wanted);
  void followPointer();
  void draw();
  void showPanels();
  void finish();

  WalkOptions& options_;
  window::Window& window_;
  std::vector<glm::vec2> probes_;
  ui::UiContext ui_;
  passes::Machine machine_;
  passes::FrameRenderer renderer_;
  Screen screen_;
  std::optional<WalkRecorder> recorder_;
  FlyCamera camera_;
  WalkPanels panels_;
  gaze::MouseGaze gaze_;
  gaze::PointOfInterest point_;
  passes::FrameResult result_;
  std::optional<ui::SettingChange> change_;
  glm::ivec2 size_{0};
  glm::vec2 lastPointer_{0.0F};  ///< while looking around, 0..1 of the window
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
  double frameSeconds_ = 0.0;  ///< time of the frame, since begin_
  int frames_ = 0;
  bool panelsShown_;
  bool looking_ = false;
  bool pointerSeen_ = false;
  bool cut_ = false;
};

}  // namespace macula::tools
