// Radiance that an environment map cannot store.
#pragma once

#include <cstddef>
#include <string>

#include "engine/scene/environment.h"

namespace macula::scene {

/// The result of limitRadiance().
struct RadianceLimit {
  std::size_t texels = 0;   ///< brighter than kMostStored
  std::size_t all = 0;      ///< texels of the panorama
  std::size_t touched = 0;  ///< texels that received light of others
  float largest = 0.0F;     ///< channel before
  int x = 0;                ///< column of the largest
  int y = 0;                ///< row from the top
  double lostShare = 0.0;   ///< of the light above kMostStored that found no room, 0..1
};

/// Replaces values that are negative, not finite or too large to be summed over a panorama.
/// @returns one line that describes the changes; empty where there are none
[[nodiscard]] std::string makeUsable(Panorama& panorama);

/// Moves the excess of texels above kMostStored to the texels around them, the nearest first: a
/// mirror then shows a larger sun of the same total brightness.
RadianceLimit limitRadiance(Panorama& panorama);

/// Describes the result in one line; empty where nothing was too bright.
[[nodiscard]] std::string describe(const RadianceLimit& limit);

}  // namespace macula::scene
