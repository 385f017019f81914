// Records a walk: watches the renderer, so that nothing that was done to it is missed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engine/recording/writer.h"
#include "engine/settings/registry.h"
#include "engine/window/window.h"
#include "passes/device_context.h"
#include "passes/frame_renderer.h"
#include "walk/options.h"

namespace macula::tools {

/// What a recording begins with, beside settings and machine.
struct RecordStart {
  std::filesystem::path folder;
  bool hashes = false;                                       ///< an image hash for each frame
  recording::SceneSource scene;                              ///< that the renderer draws
  glm::vec2 contentScale{1.0F};                              ///< of the window
  std::vector<std::pair<std::string, std::string>> options;  ///< of the command, by name
};

/// From the options of a walk. @throws InputError where the scene's file cannot be read
[[nodiscard]] RecordStart recordStartOf(const WalkOptions& options, const window::Window& window);

/// What a renderer does not know about a frame that it has drawn.
struct RecordedFrame {
  double timeSeconds = 0.0;  ///< of the frame, since the session's start
  /// Where another scene was set since the last frame: which.
  const recording::SceneSource* scene = nullptr;
  double r = 1.0;  ///< resize factor of the shading, as it was used
};

class WalkRecorder {
 public:
  /// Writes the session and restarts the renderer, so that a recording may begin at any
  /// time; readDisplay() has nothing to read until the next frame.
  /// @param registry of the renderer's settings; must outlive the recorder
  /// @throws InputError where the folder holds a recording or cannot be written
  WalkRecorder(const RecordStart& start, const settings::Registry& registry,
               const passes::DeviceContext& device, passes::FrameRenderer& renderer);

  /// To be called after each frame of that renderer. Images that are drawn beside the walk belong
  /// to a renderer of their own: frames in between are noticed, but cannot be replayed.
  void frame(const RecordedFrame& events, const passes::FrameRenderer& renderer);
  /// To be called for each sample of the gaze as it came.
  /// @param sample its time is that since the session's start
  void raw(const gaze::GazeSample& sample) {
    writer_.raw(sample);
    ++samples_;
  }

  [[nodiscard]] std::uint64_t frames() const { return frame_.index; }
  /// "120 frames, 4.0 s, 481 gaze samples"
  [[nodiscard]] std::string facts() const;

 private:
  void noteSettings();
  void noteSteps(const passes::RendererSteps& steps);

  const settings::Registry& registry_;
  bool hashes_;
  std::vector<settings::Value> values_;  ///< of the registry's entries, at the last frame
  recording::RecordingWriter writer_;
  passes::RendererSteps steps_;  ///< at the last frame
  recording::Frame frame_;
  double firstSeconds_ = 0.0;  ///< time of the first frame
  std::uint64_t samples_ = 0;  ///< of the gaze
  std::vector<std::uint8_t> pixels_;
};

}  // namespace macula::tools
