// A camera that is flown with keys and mouse.
#pragma once

#include <glm/glm.hpp>

#include "engine/scene/scene.h"

namespace macula::tools {

class FlyCamera {
 public:
  /// A slow frame moves as if it had been this fast, in seconds, so that a pause does not end
  /// behind a wall.
  static constexpr float kLongestStep = 0.1F;

  /// What the keys and the mouse ask for in one frame.
  struct Motion {
    glm::vec3 move{0.0F};  ///< right, up, ahead, each -1..1
    glm::vec2 turn{0.0F};  ///< radians to the right and up
    bool fast = false;
  };

  /// @param start where reset() goes back to; a roll about its view axis is not kept
  /// @param sceneRadius metres, > 0; speed and planes follow from it
  FlyCamera(const scene::Camera& start, float sceneRadius);

  /// Goes to another camera's place, heading and field of view; its roll is not kept.
  void place(const scene::Camera& camera);
  /// @param seconds since the last frame, >= 0
  void advance(const Motion& motion, float seconds);
  void reset();
  /// Multiplies the speed, within bounds.
  void scaleSpeed(float factor);
  [[nodiscard]] float speed() const { return speed_; }  ///< times that of a new scene
  [[nodiscard]] float sceneRadius() const { return radius_; }

  [[nodiscard]] scene::Camera camera() const;

 private:
  [[nodiscard]] glm::vec3 ahead() const;

  scene::Camera start_;
  float radius_;
  float fov_ = 0.0F;    ///< vertical, radians
  float speed_ = 1.0F;  ///< times the speed that suits the scene's size
  glm::vec3 position_{0.0F};
  float yaw_ = 0.0F;    ///< radians; 0 looks along -z, positive turns right
  float pitch_ = 0.0F;  ///< radians; positive looks up
};

}  // namespace macula::tools
