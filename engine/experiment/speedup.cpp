#include "engine/experiment/speedup.h"

#include <algorithm>

namespace macula::experiment {

const Point* baseOf(const Experiment& experiment, std::span<const Point> points,
                    const Point& point) {
  const std::string& base = experiment.study(textOf(point, "study")).base;
  if (base.empty()) return nullptr;
  const auto found = std::find_if(points.begin(), points.end(), [&](const Point& other) {
    return textOf(other, "variant") == base && sameGroup(point, other) && interleaved(point, other);
  });
  return found == points.end() ? nullptr : &*found;
}

std::optional<double> speedupOf(const Point& base, const Point& point, std::string_view metric) {
  const auto whole = metricOf(base, metric);
  const auto own = metricOf(point, metric);
  if (!whole || !own || !(*whole > 0.0) || !(*own > 0.0)) return std::nullopt;
  return *whole / *own;
}

void giveSpeedups(const Experiment& experiment, std::vector<Point>& points) {
  for (Point& point : points) {
    point.erase("speedup");
    const Point* base = baseOf(experiment, points, point);
    const auto speedup = base == nullptr ? std::nullopt : speedupOf(*base, point, "ms.total");
    if (speedup) point["speedup"] = *speedup;
  }
}

}  // namespace macula::experiment
