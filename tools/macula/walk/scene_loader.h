// Scenes are read, decoded and framed on a thread of their own.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common.h"
#include "engine/scene/camera_path.h"
#include "engine/scene/gpu_scene.h"
#include "walk/background_job.h"

namespace macula::tools {

/// A scene that is ready to go to the GPU, with where to look at it from.
struct ReadyScene {
  std::string name;
  LoadedScene loaded;
  scene::CameraPath orbit{scene::Camera{}};
  scene::Camera start;      ///< the scene's first camera, or the orbit's first place
  bool keepsPlace = false;  ///< it is the scene that was shown before
};

/// A scene on the GPU.
struct ShownScene {
  std::string name;
  std::unique_ptr<scene::GpuScene> gpu;
  std::string facts;                  ///< one line: triangles, draws, lights
  std::vector<std::string> warnings;  ///< what is not drawn as it is given
};

/// Uploads. To be called on the thread of the context. @throws InputError where memory is short
[[nodiscard]] ShownScene upload(const ReadyScene& ready);

class SceneLoader {
 public:
  /// Begins to load, in place of what is loading.
  /// @param settings those that go into the scene: lighting, order, seed, environment
  /// @param keepsPlace the camera is to stay where it is
  void request(std::string name, const passes::RenderSettings& settings, bool keepsPlace);
  /// Whatever is loading will not arrive.
  void cancel();
  [[nodiscard]] bool busy() const { return wanted_.has_value(); }
  /// Of the scene that is loading.
  [[nodiscard]] std::string name() const { return wanted_ ? wanted_->name : std::string(); }
  /// What is done now: "reading and decoding".
  [[nodiscard]] std::string stage() const;
  [[nodiscard]] double seconds() const;

  /// The scene, once. The call before it makes stage() say that the upload comes next, so that a
  /// frame can show it. @throws InputError where it cannot be loaded
  [[nodiscard]] std::optional<ReadyScene> poll();

 private:
  enum class Stage { Reading, Framing, Uploading };
  struct Wanted {
    std::string name;
    passes::RenderSettings settings;
    bool keepsPlace = false;
    std::chrono::steady_clock::time_point begin;
  };
  void start();

  std::optional<Wanted> wanted_;
  bool stale_ = false;  ///< the job's result is not what is wanted any more
  std::optional<ReadyScene> arrived_;
  std::atomic<Stage> stage_ = Stage::Reading;
  BackgroundJob<ReadyScene> job_;  ///< last: its destructor waits for the thread
};

}  // namespace macula::tools
