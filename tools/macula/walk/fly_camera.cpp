#include "walk/fly_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace macula::tools {
namespace {

constexpr float kRadiiPerSecond = 0.15F;  ///< crosses a scene in about 13 seconds
constexpr float kFastFactor = 4.0F;
constexpr float kSlowest = 0.01F;  ///< bounds of scaleSpeed()
constexpr float kFastest = 100.0F;

/// Straight up and down have no heading.
constexpr float kSteepest = 1.55F;

/// Planes for going anywhere in the scene and standing well outside of it, in radii. Depth is
/// reversed 32-bit float, which loses little to a near plane this close.
constexpr float kNearRadii = 0.002F;
constexpr float kFarRadii = 8.0F;

}  // namespace

FlyCamera::FlyCamera(const scene::Camera& start, float sceneRadius)
    : start_(start), radius_(sceneRadius) {
  start_.nearPlane = std::min(start.nearPlane, kNearRadii * radius_);
  start_.farPlane = std::max(start.farPlane, kFarRadii * radius_);
  reset();
}

void FlyCamera::reset() {
  place(start_);
}

void FlyCamera::place(const scene::Camera& camera) {
  const glm::vec3 view = glm::normalize(camera.target - camera.position);
  position_ = camera.position;
  fov_ = camera.verticalFov;
  yaw_ = std::atan2(view.x, -view.z);
  pitch_ = std::clamp(std::asin(std::clamp(view.y, -1.0F, 1.0F)), -kSteepest, kSteepest);
}

void FlyCamera::scaleSpeed(float factor) {
  speed_ = std::clamp(speed_ * factor, kSlowest, kFastest);
}

glm::vec3 FlyCamera::ahead() const {
  return {std::sin(yaw_) * std::cos(pitch_), std::sin(pitch_), -std::cos(yaw_) * std::cos(pitch_)};
}

void FlyCamera::advance(const Motion& motion, float seconds) {
  yaw_ = std::remainder(yaw_ + motion.turn.x, glm::two_pi<float>());
  pitch_ = std::clamp(pitch_ + motion.turn.y, -kSteepest, kSteepest);
  const glm::vec3 up(0.0F, 1.0F, 0.0F);
  const glm::vec3 right = glm::normalize(glm::cross(ahead(), up));
  const float step = kRadiiPerSecond * radius_ * speed_ * (motion.fast ? kFastFactor : 1.0F) *
                     std::min(seconds, kLongestStep);
  position_ += step * (motion.move.x * right + motion.move.y * up + motion.move.z * ahead());
}

scene::Camera FlyCamera::camera() const {
  scene::Camera camera = start_;
  camera.position = position_;
  camera.target = position_ + ahead();
  camera.up = {0.0F, 1.0F, 0.0F};
  camera.verticalFov = fov_;
  return camera;
}

}  // namespace macula::tools
