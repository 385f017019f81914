#include "engine/measure/gaze_weight.h"

#include <cmath>
#include <cstddef>

namespace macula::measure {

double acuityWeight(double eccentricity) {
  const double share = kFovealMar / (kMarSlope * eccentricity + kFovealMar);
  return share * share;
}

double gazeWeightedMean(const Plane& map, const glm::dvec2& gaze, double pixelsPerDegree) {
  const double x0 = gaze.x * map.width;
  const double y0 = gaze.y * map.height;
  double sum = 0.0;
  double weights = 0.0;
  std::size_t pixel = 0;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x, ++pixel) {
      const double distance = std::hypot(x + 0.5 - x0, y + 0.5 - y0);
      const double weight = acuityWeight(distance / pixelsPerDegree);
      sum += weight * static_cast<double>(map.values[pixel]);
      weights += weight;
    }
  }
  return sum / weights;
}

}  // namespace macula::measure
