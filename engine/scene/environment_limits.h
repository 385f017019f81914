// What a panorama holds that an environment cannot.
#pragma once

#include <cstddef>
#include <string>

#include "engine/scene/environment.h"

namespace macula::scene {

/// What limitRadiance() did.
struct RadianceLimit {
  std::size_t texels = 0;   ///< brighter than kMostStored
  std::size_t all = 0;      ///< texels of the panorama
  std::size_t touched = 0;  ///< texels that took light of others
  float largest = 0.0F;     ///< channel before
  int x = 0;                ///< column of the largest
  int y = 0;                ///< row from the top
  double lostShare = 0.0;   ///< of the light above kMostStored that found no room, 0..1
};

/// Makes every value a number from 0 up that sums of a panorama can hold.
/// @returns what was changed in one line; empty where nothing was
[[nodiscard]] std::string makeUsable(Panorama& panorama);

/// Takes from texels above kMostStored what is too much and gives it to the texels around, the
/// nearest first: a mirror then shows a sun that is larger, and as bright in sum.
RadianceLimit limitRadiance(Panorama& panorama);

/// The same in one line; empty where nothing was too bright.
[[nodiscard]] std::string describe(const RadianceLimit& limit);

}  // namespace macula::scene
