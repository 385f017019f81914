// Targets of means: a ratio taken on each scene, and the mean of all.
#pragma once

#include <span>
#include <vector>

#include "engine/experiment/target.h"

namespace macula::experiment {

/// The ratio on one scene.
struct ScenePart {
  const Point* point = nullptr;  ///< of the variant `of`
  TargetRow row;
};

/// One row for each study, size, seed, light, budget and value of a sweep: the arithmetic mean over
/// the target's scenes, or, where it names none, over those of the study that are not optional, so
/// that a mean does not depend on the files that are there. Unmeasured where one of them is.
[[nodiscard]] std::vector<TargetRow> meansOverScenes(const Experiment& experiment,
                                                     const Target& target,
                                                     std::span<const ScenePart> parts);

}  // namespace macula::experiment
