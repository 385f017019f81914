// A walk from the opening of the window to its end.
#pragma once

#include <chrono>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/ui/frame_rate.h"
#include "engine/ui/ui_context.h"
#include "engine/window/held_keys.h"
#include "engine/window/window.h"
#include "frame_control.h"
#include "passes/device_context.h"
#include "passes/frame_renderer.h"
#include "walk/camera_control.h"
#include "walk/cpu_times.h"
#include "walk/error_check.h"
#include "walk/first_image.h"
#include "walk/frame_events.h"
#include "walk/gaze_control.h"
#include "walk/legend_overlay.h"
#include "walk/options.h"
#include "walk/panels.h"
#include "walk/recorder.h"
#include "walk/request.h"
#include "walk/scene_loader.h"
#include "walk/screen.h"
#include "walk/script.h"
#include "walk/second_view.h"

namespace macula::tools {

class WalkSession {
 public:
  /// @param window its context is current
  /// @throws InputError where an option cannot be understood
  WalkSession(WalkOptions& options, window::Window& window, GazeSources gazeSources);
  /// Draws frames until the window is closed or the frames of the options are drawn.
  /// @throws InputError where the first scene or the first gaze source cannot be loaded, or a file
  ///   of the options cannot be written
  void run();

 private:
  using Clock = std::chrono::steady_clock;

  // session.cpp: the loop and a frame's way through it
  [[nodiscard]] bool done() const;
  void loadingFrame();
  void frame();
  void prepareEvents(Clock::time_point now);
  void measureTimes();
  void noteTimes();
  void steer(float seconds);
  void followPointer();
  void placeGaze();
  void finish();
  [[nodiscard]] bool busy() const;

  // session_record.cpp: what is recorded
  void beginRecording();
  void record();
  void endRecording(const std::string& reason);
  void sumUpRecordings();

  // session_draw.cpp: rendering, overlays, stills, and what is undone where the device refuses
  void drawOverlays();
  void draw();
  void drawFirst();
  void adoptResult(const passes::FrameResult& result);
  [[nodiscard]] passes::Wanted wanted() const;
  bool takeBack(const InputError& error);
  void drawSecond(bool firstChanged);
  void compose();
  void takeStills();
  void writeLinearPicture(const std::string& file);
  void measureErrors(const std::string& against);

  // session_input.cpp: keys, text and the pointer, event by event
  void takeInput();
  void readEvent(const window::InputEvent& event);
  void readPress(int key, int modifiers);
  void lookAround(bool wanted);
  void settleFocus();
  [[nodiscard]] bool pictureComesFirst() const;

  // session_requests.cpp: what the user asks for
  void grantRequests();
  void grant(const Request& request);
  void noteChange();
  void askForScene(const std::string& name);
  void drop(const std::string& path);
  void close();
  void togglePath(const std::string& path);
  void toggleRecording();
  void nextMap(const std::string& name);
  void askForErrors(const std::string& against);
  [[nodiscard]] std::string commandLine() const;
  [[nodiscard]] std::string freshName(const std::string& prefix, std::string_view extension);
  void say(std::string text, bool error = false);

  // session_jobs.cpp: results of the threads
  void pollJobs();
  void loadScene(const std::string& name);
  void adopt(const ReadyScene& ready);
  void startPicture(std::string file, std::function<void()> write);

  WalkOptions& options_;
  window::Window& window_;
  std::vector<glm::vec2> probes_;
  Script script_;
  ui::UiContext ui_;
  Screen screen_;
  LegendOverlay legends_;
  SceneLoader loader_;
  GazeControl gaze_;
  CameraControl camera_;
  ErrorCheck errors_;
  Panels panels_;
  // Made once the window shows that something goes on: they compile programs.
  std::unique_ptr<passes::DeviceContext> device_;
  std::unique_ptr<passes::FrameRenderer> renderer_;
  std::unique_ptr<SecondView> second_;
  std::unique_ptr<FirstImage> firstImage_;  ///< until the first frame was drawn
  std::unique_ptr<FrameControl> control_;
  ShownScene scene_;
  ShownScene sceneBefore_;  ///< until the new one was drawn once
  std::optional<CameraControl> cameraBefore_;
  std::optional<WalkRecorder> recorder_;
  std::vector<std::string> recordings_;  ///< what is being recorded, in words
  std::string summary_;                  ///< of the recording, for the terminal; empty: none
  ui::FrameRate rate_;
  passes::FrameResult result_;  ///< the newest there is; of an earlier frame than the last
  bool resultNew_ = false;      ///< it came with the last frame
  bool drawnOnce_ = false;      ///< a frame was drawn whose length is not known yet
  CpuHistory cpuHistory_;
  double cpuBegin_ = 0.0;            ///< threadMs() at the begin of the frame
  double drawMs_ = 0.0;              ///< of threadMs(), while the frame was being drawn
  std::uint64_t blockingCalls_ = 0;  ///< of the last frame, before what its report needs
  FrameEvents events_;
  std::optional<ui::SettingChange> change_;
  std::optional<ui::SettingChange> sceneChange_;  ///< a setting that the scene is loaded again for
  std::optional<Message> message_;
  std::string lastMessage_;  ///< stays for the report
  Requests requests_;
  BackgroundJob<std::string> picture_;
  std::set<std::string> givenNames_;  ///< of pictures, written or on their way
  std::string pendingPicture_;        ///< PNG of this frame; empty: none
  std::string pendingLinear_;         ///< the same for EXR
  std::string pendingErrors_;         ///< "exact" or "second" where this frame is to be measured
  glm::ivec2 size_{0};
  glm::ivec2 pictureSize_{0};
  window::HeldKeys keys_;
  int focusFrames_ = 0;  ///< of the UI, until a field that was asked for has the keyboard
  std::optional<glm::dvec2> pointer_;  ///< place of the last event, screen coordinates
  glm::dvec2 looked_{0.0};  ///< way of the pointer while looking around, since the last frame
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
  int frames_ = 0;          ///< without those that waited for a thread
  int loadingFrames_ = 0;   ///< drawn while a scene was loading
  std::string guessedLog_;  ///< a file that was opened as a gaze log because it is nothing else
  std::optional<double> firstImageMs_;  ///< since the walk began: something of the scene was shown
  std::optional<double> firstFrameMs_;  ///< all of it was
  bool firstGaze_ = true;               ///< the source of the options has not been opened yet
  bool looking_ = false;
  bool pointerSeen_ = false;
};

}  // namespace macula::tools
