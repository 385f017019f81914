#include "engine/gaze/display.h"

#include <cmath>

namespace macula::gaze {
namespace {

// From a phone to a wall, in millimetres.
constexpr settings::Range kSizes{.min = 10.0, .max = 100000.0};

/// From the eye to a place, in millimetres.
glm::dvec3 lineOfSight(const glm::dvec2& place, const Display& display) {
  return {(place.x - 0.5) * display.widthMm, (place.y - 0.5) * display.heightMm,
          display.distanceMm};
}

}  // namespace

void registerSettings(settings::Registry& registry, Display& display) {
  registry.add({.key = "display.widthMm", .unit = "mm", .help = "width of the picture's area"},
               display.widthMm, kSizes);
  registry.add({.key = "display.heightMm", .unit = "mm", .help = "height of the picture's area"},
               display.heightMm, kSizes);
  registry.add({.key = "display.distanceMm", .unit = "mm", .help = "from the eyes to the display"},
               display.distanceMm, kSizes);
}

glm::dvec2 placeOfAngles(const glm::dvec2& degrees, const Display& display) {
  const glm::dvec2 fromMiddle = display.distanceMm * glm::tan(glm::radians(degrees));
  return 0.5 + fromMiddle / glm::dvec2(display.widthMm, display.heightMm);
}

double angleBetween(const glm::dvec2& a, const glm::dvec2& b, const Display& display) {
  const glm::dvec3 u = lineOfSight(a, display);
  const glm::dvec3 v = lineOfSight(b, display);
  // atan2 stays exact for small angles, where acos of the cosine does not.
  return glm::degrees(std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)));
}

}  // namespace macula::gaze
