// Counts how many surfaces lie behind one another, so that a recipe can keep to a promised depth.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene {

/// A square frame of counters, seen through a camera. Rasterises both sides of every triangle with
/// the rules of OpenGL (pixel centres, top-left edges) in integers, so that the outcome does not
/// depend on the machine. Opaque surfaces that are not passed to occlude() make real counts lower.
class DepthCounter {
 public:
  /// @param tanHalfFov tangent of half the camera's field of view; given apart from the camera
  ///   because libm's tangent need not give the same bits everywhere
  /// @param size width and height in pixels, >= 1
  DepthCounter(const Camera& camera, float tanHalfFov, int size);

  /// Later meshes are not counted where they lie behind this opaque mesh. Triangles that
  /// reach behind the camera's near plane hide nothing.
  void occlude(const Primitive& mesh, const glm::mat4& transform);

  /// Adds a mesh if no pixel then holds more than `limit` fragments; else leaves the counts alone.
  /// Triangles that reach behind the camera's near plane are not counted.
  /// @return whether it was added
  bool addWithin(const Primitive& mesh, const glm::mat4& transform, int limit);

  /// Share of the frame, 0..1, where at least one fragment was counted.
  [[nodiscard]] float coverage() const;

 private:
  struct Corner {
    std::int64_t x = 0;  ///< in 1/256 pixel
    std::int64_t y = 0;
    float nearness = 0.0F;  ///< 1 / distance along the view axis; linear over the screen
    bool visible = false;
  };

  void project(const Primitive& mesh, const glm::mat4& transform);
  /// Calls `visit(pixel, nearness)` for the pixels of all projected triangles.
  template <typename Visit>
  void draw(const Primitive& mesh, const Visit& visit) const;
  template <typename Visit>
  void drawTriangle(const std::array<Corner, 3>& corners, const Visit& visit) const;

  glm::vec3 position_;
  glm::vec3 right_;
  glm::vec3 up_;
  glm::vec3 forward_;
  float nearPlane_;
  float pixelsPerUnit_;
  int size_;
  std::vector<Corner> corners_;
  std::vector<std::uint16_t> counts_;
  std::vector<float> occluder_;     ///< nearness of the nearest opaque surface; empty: none
  std::vector<std::size_t> drawn_;  ///< pixels hit by the mesh being added, with repeats
};

}  // namespace macula::scene
