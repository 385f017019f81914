#include "walk/camera_control.h"

#include <utility>

#include "common.h"
#include "engine/core/error.h"
#include "engine/core/file.h"

namespace macula::tools {
namespace {

/// Time between two keys of a recording: a spline through them follows any walk closely.
constexpr double kKeySeconds = 1.0 / 30.0;

bool moves(const FlyCamera::Motion& motion) {
  return motion.move != glm::vec3(0.0F) || motion.turn != glm::vec2(0.0F);
}

}  // namespace

void CameraControl::setScene(const scene::Camera& start, const scene::CameraPath& orbit,
                             const scene::Bounds& bounds, bool keepsPlace) {
  const scene::Camera before = camera_;
  const bool playedOrbit = played_ && pathName_ == "auto";
  fly_ = FlyCamera(start, bounds.radius());
  if (keepsPlace) fly_.place(before);
  orbit_ = orbit;
  bounds_ = bounds;
  if (!keepsPlace) {
    played_.reset();
    if (playedOrbit) play("auto");
  }
  camera_ = fly_.camera();
  cut_ = true;
}

void CameraControl::advance(const FlyCamera::Motion& motion, float seconds) {
  if (played_ && moves(motion)) stopPlaying();
  if (played_) {
    playOn(seconds);
  } else {
    fly_.advance(motion, seconds);
    camera_ = fly_.camera();
  }
  if (recording_) record(seconds);
}

void CameraControl::playOn(float seconds) {
  const scene::PathPlayer::Moment moment =
      played_->moveTo(played_->time() + static_cast<double>(seconds));
  cut_ = cut_ || moment.cut;
  camera_ = moment.camera;
  const bool repeats = pathName_ == "auto";
  if (!repeats && played_->time() >= pathSeconds()) stopPlaying();
}

void CameraControl::play(const std::string& spec) {
  const std::string name = spec.empty() ? pathName_ : spec;
  scene::CameraPath path = orbit_;
  if (name != "auto") {
    path = readCamera(name);
    path.fitPlanes(bounds_);
  }
  pathName_ = name;
  camera_ = played_.emplace(path).moveTo(0.0).camera;
  cut_ = true;
}

void CameraControl::stopPlaying() {
  played_.reset();
  // The walk goes on from where the path was left.
  fly_.place(camera_);
}

void CameraControl::reset() {
  played_.reset();
  fly_.reset();
  cut_ = true;
}

void CameraControl::startRecording() {
  keys_.clear();
  recordedTime_ = 0.0;
  recording_ = true;
}

void CameraControl::record(float seconds) {
  if (!keys_.empty()) recordedTime_ += static_cast<double>(seconds);
  if (!keys_.empty() && !cut_ && recordedTime_ - keys_.back().time < kKeySeconds) return;
  if (!keys_.empty() && recordedTime_ <= keys_.back().time) return;
  keys_.push_back({recordedTime_, camera_.position, camera_.target, camera_.verticalFov,
                   cut_ && !keys_.empty()});
}

void CameraControl::finishRecording(const std::filesystem::path& file) {
  recording_ = false;
  if (keys_.empty()) failInput("nothing was recorded; let at least one frame pass");
  writeFileAtomically(file, scene::cameraPathCsv(keys_));
  pathName_ = file.string();
}

bool CameraControl::takeCut() {
  return std::exchange(cut_, false);
}

}  // namespace macula::tools
