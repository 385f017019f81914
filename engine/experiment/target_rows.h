// The rows of one target: a target on each scene, size, seed, light and budget that it is about.
#pragma once

#include <span>
#include <vector>

#include "engine/experiment/target.h"

namespace macula::experiment {

/// Judges a target by the points of its variants; one row that says so where there are none.
[[nodiscard]] std::vector<TargetRow> rowsOf(const Experiment& experiment, const Target& target,
                                            std::span<const Point> points);

}  // namespace macula::experiment
