// Defines of the shaders that evaluate how many slots pixels demand: see demand.cpp.
#pragma once

#include "engine/gl/shader_source.h"
#include "passes/oit/plan.h"

namespace macula::passes {

/// Those of shaders/lib/demand.glsl, but for DEMAND_VECTORS.
[[nodiscard]] gl::Defines demandDefines(const OitPlan& plan);
/// Those of shaders/lib/slices.glsl.
[[nodiscard]] gl::Defines sliceDefines(const OitPlan& plan);

}  // namespace macula::passes
