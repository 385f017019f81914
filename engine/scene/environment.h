// Image-based light: an equirectangular panorama, its irradiance and its blurred levels.
#pragma once

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace macula::scene {

/// One level of the panorama: linear RGB, rows from the top (+y).
struct Panorama {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;
  [[nodiscard]] const glm::vec3& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// Light from all directions, ready for shading.
struct Environment {
  /// Level 0 is the panorama (scaled to at most kMaxSide); level i is blurred with the GGX lobe of
  /// roughness i / (levels - 1) (Karis 2013, "Real Shading in Unreal Engine 4", with V = N). No
  /// texel exceeds kMostStored; the excess is spread over the texels around it.
  std::vector<Panorama> levels;
  /// Irradiance / pi as spherical harmonics up to l = 2 (Ramamoorthi and Hanrahan 2001), from the
  /// radiance as it is given.
  std::array<glm::vec3, 9> irradiance{};
  /// Changes made to the picture, one line each, without the file's name.
  std::vector<std::string> warnings;
};

/// The most radiance that a level holds: the largest half float.
inline constexpr float kMostStored = 65504.0F;

/// World direction of a place in the panorama, u and v 0..1 from its top left. The middle of the
/// picture looks along -z, its right edge and its left edge along +z, the top along +y.
[[nodiscard]] glm::vec3 directionOf(float u, float v);

/// The inverse: u and v of a direction.
[[nodiscard]] glm::vec2 panoramaUv(const glm::vec3& direction);

/// Filters a panorama. Values that are not numbers and negative ones count as 0, infinite ones as
/// kMostStored.
[[nodiscard]] Environment makeEnvironment(Panorama panorama);

}  // namespace macula::scene
