// Who moves the camera: the user or a path; and what is recorded of it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/camera_path.h"
#include "walk/fly_camera.h"

namespace macula::tools {

class CameraControl {
 public:
  /// @param orbit what `auto` plays
  /// @param keepsPlace the camera stays, because the scene is the one shown before
  void setScene(const scene::Camera& start, const scene::CameraPath& orbit,
                const scene::Bounds& bounds, bool keepsPlace);

  /// Moves by what the user asks for, which also ends a playing path, or along the path.
  void advance(const FlyCamera::Motion& motion, float seconds);
  void reset();
  void scaleSpeed(float factor) { fly_.scaleSpeed(factor); }

  /// @param spec `auto` for the orbit, a path file or a recording; empty: what was played or
  /// recorded
  ///   last
  /// @throws InputError as readCamera()
  void play(const std::string& spec);
  void stopPlaying();
  [[nodiscard]] bool playing() const { return played_.has_value(); }
  /// What plays, or would play next: "auto" or a file.
  [[nodiscard]] const std::string& pathName() const { return pathName_; }
  [[nodiscard]] double playedSeconds() const { return played_ ? played_->time() : 0.0; }
  [[nodiscard]] double pathSeconds() const { return played_ ? played_->path().duration() : 0.0; }

  void startRecording();
  [[nodiscard]] bool recording() const { return recording_; }
  [[nodiscard]] std::size_t recordedKeys() const { return keys_.size(); }
  [[nodiscard]] double recordedSeconds() const { return recordedTime_; }
  /// Writes the recorded path, which play() then plays. @throws InputError
  void finishRecording(const std::filesystem::path& file);

  [[nodiscard]] scene::Camera camera() const { return camera_; }
  [[nodiscard]] float speed() const { return fly_.speed(); }
  /// Whether the camera jumped since the last call.
  [[nodiscard]] bool takeCut();

 private:
  void playOn(float seconds);
  void record(float seconds);

  FlyCamera fly_{scene::Camera{}, 1.0F};
  scene::Camera camera_;
  scene::CameraPath orbit_{scene::Camera{}};
  scene::Bounds bounds_;
  std::optional<scene::PathPlayer> played_;
  std::string pathName_ = "auto";
  bool cut_ = false;
  bool recording_ = false;
  double recordedTime_ = 0.0;
  std::vector<scene::CameraKey> keys_;
};

}  // namespace macula::tools
