// What a replay draws and what only it knows of the frames: along a path, or as recorded.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "common.h"
#include "engine/measure/run_record.h"
#include "engine/recording/frame_source.h"
#include "replay_painter.h"

namespace macula::tools {

/// A frame of a replay, and what came of it.
struct DrawnFrame {
  const recording::Frame& source;
  const passes::FrameResult& result;
  const passes::FrameRenderer& renderer;
  const std::string& imageSha256;
};

class ReplayInput {
 public:
  ReplayInput() = default;
  ReplayInput(const ReplayInput&) = delete;
  ReplayInput& operator=(const ReplayInput&) = delete;
  virtual ~ReplayInput() = default;

  [[nodiscard]] virtual recording::FrameSource& frames() = 0;
  /// Times that the first frame is drawn before it counts.
  [[nodiscard]] virtual int warmup() const = 0;
  /// Settings that the first scene is loaded with: those of the first frame may be others.
  [[nodiscard]] virtual recording::Settings settings() const { return {}; }
  /// The first scene; its name is that of the report.
  [[nodiscard]] virtual recording::SceneSource scene() const = 0;
  /// Loads scene(), and each one that a frame sets. Called once for each.
  /// @throws InputError where it cannot be loaded or is not the one that was recorded
  [[nodiscard]] virtual LoadedScene load(const recording::SceneSource& source) = 0;
  /// Compares a frame that was drawn with what is expected of it, or completes its record.
  virtual void judge(const DrawnFrame& drawn, measure::FrameRecord& record) = 0;
  /// Fills in what is the same for all frames. After the last of them.
  virtual void describe(measure::RunRecord& run) = 0;
  /// One line for a terminal, without its end.
  [[nodiscard]] virtual std::string summary(const nlohmann::ordered_json& report) const = 0;
  /// To be called last. @throws Difference where an image is not the recorded one
  virtual void finish() const {}
};

/// Along the camera and the gaze of the options. Warns of what is not drawn or read as it is given.
/// @param size of the images, pixels
/// @throws InputError where scene, gaze or camera cannot be read
[[nodiscard]] std::unique_ptr<ReplayInput> openPath(const ReplayOptions& options, glm::ivec2 size);

/// The recording in the folder that the options name as their scene.
/// @throws InputError where the folder is none, has no frame or an unknown quality control, or
///   options were given that a recording answers
[[nodiscard]] recording::Recording readForReplay(const ReplayOptions& options);

/// The frames of a walk drawn again, bit for bit: what was done to its renderer is done to this
/// one. Where the recording holds image hashes, they are compared.
[[nodiscard]] std::unique_ptr<ReplayInput> openRecording(const ReplayOptions& options,
                                                         recording::Recording recording);

/// The time of a frame in words. @param summary of the report
[[nodiscard]] std::string medianText(const nlohmann::ordered_json& summary);

}  // namespace macula::tools
