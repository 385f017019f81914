// What the passes share that walk lists of what transparency covers: shaders/lib/covered.glsl.
#pragma once

#include "passes/oit/oit_pass.h"
#include "shared/oit_totals.h"

namespace macula::passes {

/// @param list LIST_OF_TILES or LIST_OF_SAMPLES
[[nodiscard]] frame::Resource listResource(int list);
[[nodiscard]] gl::Defines::value_type listedTileDefine(const OitPlan& plan);

void declareCoveredTiles(frame::PassDeclaration& d);
/// Binds the list of tiles and dispatches a thread for each entry.
void dispatchCoveredTiles(const frame::PassContext& context);

}  // namespace macula::passes
