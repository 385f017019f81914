// Where the frames of a run come from: a camera path with a gaze, single views, or a recording.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "engine/gaze/source.h"
#include "engine/recording/recording.h"
#include "engine/scene/camera_path.h"

namespace macula::recording {

/// Frames in their order, each with all that it is drawn from. A recording's frames also say what
/// was done before them: settings, scene, size, controls and resets.
class FrameSource {
 public:
  FrameSource() = default;
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;
  virtual ~FrameSource() = default;

  [[nodiscard]] virtual std::size_t count() const = 0;
  /// The frame that next() gives first; valid as long as the source.
  [[nodiscard]] virtual const Frame& first() const = 0;
  /// The next frame, valid until the following call; null after the last.
  [[nodiscard]] virtual const Frame* next() = 0;
};

/// Frame i is where a camera path and a gaze are at i / fps seconds.
class PathFrames final : public FrameSource {
 public:
  /// @param gaze must outlive the frames; is asked from time 0 on
  /// @param fps > 0 @param count at least 1
  PathFrames(const scene::CameraPath& path, gaze::GazeSource& gaze, double fps, std::size_t count,
             glm::ivec2 size);

  [[nodiscard]] std::size_t count() const override { return count_; }
  [[nodiscard]] const Frame& first() const override { return first_; }
  [[nodiscard]] const Frame* next() override;

 private:
  scene::PathPlayer player_;
  gaze::GazeSource& gaze_;
  double fps_;
  std::size_t count_;
  Frame first_;
  Frame frame_;
  std::size_t next_ = 0;
};

/// Frames that exist already: those of a recording, or one for each of some views.
class ListedFrames final : public FrameSource {
 public:
  /// @param frames at least one
  explicit ListedFrames(std::vector<Frame> frames) : frames_(std::move(frames)) {}
  /// Views at time 0, looked at in their middle.
  ListedFrames(const std::vector<scene::Camera>& views, glm::ivec2 size);

  [[nodiscard]] std::size_t count() const override { return frames_.size(); }
  [[nodiscard]] const Frame& first() const override { return frames_.front(); }
  [[nodiscard]] const Frame* next() override {
    return next_ < frames_.size() ? &frames_[next_++] : nullptr;
  }

 private:
  std::vector<Frame> frames_;
  std::size_t next_ = 0;
};

/// The camera of a recording as a path for other scenes, times and sizes.
/// @param recording of at least one frame
[[nodiscard]] scene::CameraPath cameraPathOf(const Recording& recording);

}  // namespace macula::recording
