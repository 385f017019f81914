// What the passes of the auction of slots share: shaders/lib/bidder_inputs.glsl.
#pragma once

#include "passes/oit/oit_pass.h"

namespace macula::passes {

void declareBids(frame::PassDeclaration& d, const OitPlan& plan);
[[nodiscard]] gl::Defines bidDefines(const OitPlan& plan);
/// Those of shaders/lib/slices.glsl.
void addSliceDefines(gl::Defines& defines, const OitPlan& plan);
void bindBids(const frame::PassContext& context, const OitPlan& plan);

}  // namespace macula::passes
