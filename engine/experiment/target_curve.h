// Targets of curves: how far the points of one sweep lie above those of another at equal speed-up.
#pragma once

#include <span>

#include "engine/experiment/target.h"

namespace macula::experiment {

/// Judges the two curves of row.target in the group of `lead`, any point of the first.
void judgeCurve(const Experiment& experiment, std::span<const Point> points, const Point& lead,
                TargetRow& row);

}  // namespace macula::experiment
