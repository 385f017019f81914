// How many times faster a point is than its study's base.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/experiment/point.h"

namespace macula::experiment {

/// The point of the study's base variant in a point's group; null where there is none, or where the
/// two were not interleaved.
[[nodiscard]] const Point* baseOf(const Experiment& experiment, std::span<const Point> points,
                                  const Point& point);

/// A metric of the base over that of a point: none where either has none, or the point's is 0.
[[nodiscard]] std::optional<double> speedupOf(const Point& base, const Point& point,
                                              std::string_view metric);

/// Gives "speedup", of ms.total, to every point that has a base beside it.
void giveSpeedups(const Experiment& experiment, std::vector<Point>& points);

}  // namespace macula::experiment
