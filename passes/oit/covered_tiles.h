// What the passes that walk the list of covered tiles share: shaders/lib/covered_tile.glsl.
#pragma once

#include "passes/oit/oit_pass.h"

namespace macula::passes {

[[nodiscard]] gl::Defines::value_type listedTileDefine(const OitPlan& plan);
void declareCoveredTiles(frame::PassDeclaration& d);
/// Binds the list and dispatches a thread for each entry.
void dispatchCoveredTiles(const frame::PassContext& context);

}  // namespace macula::passes
