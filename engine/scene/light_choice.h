// Selects the lights of a frame where a scene has more than the shaders take.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene {

/// Selects the lights that contribute most to the view. It depends on the camera alone, not on
/// earlier frames; ties are resolved in the scene's order.
class LightChoice {
 public:
  LightChoice() = default;
  /// @param bounds of the lit surfaces
  LightChoice(const std::vector<Light>& lights, const Bounds& bounds);

  /// Whether there are more lights than a frame takes.
  [[nodiscard]] bool needed() const { return lights_.size() > kMostLights; }
  /// Indices of the lights of a frame, increasing, at most kMostLights. Allocates nothing.
  /// @param aspect width over height of the image @returns until the next call
  std::span<const std::uint32_t> choose(const Camera& camera, float aspect);

  /// An estimate of the light that a light adds to the image: illuminance, averaged over the image
  /// and over where a surface may be, from the near side of the bounds to the far one. Neither
  /// shadows nor the ways that surfaces face are considered.
  [[nodiscard]] double share(const Light& light, const Camera& camera, float aspect) const;

 private:
  std::vector<Light> lights_;
  Bounds bounds_;  ///< a little larger than given, so that no line through them has no length
  std::vector<double> shares_;
  std::vector<std::uint32_t> order_;
};

/// One line that says how many lights a frame takes and which lights a camera leaves out; empty
/// where it leaves out none.
/// @param from names the camera, for example "the first frame"
[[nodiscard]] std::string lightsLeftOut(const Scene& scene, const Camera& camera, float aspect,
                                        const std::string& from);

}  // namespace macula::scene
