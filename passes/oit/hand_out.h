// What every pass that gives pixels their slots writes: shaders/lib/hand_out.glsl.
#pragma once

#include "passes/oit/oit_pass.h"

namespace macula::passes {

void declareHandOut(frame::PassDeclaration& d, const OitPlan& plan);
[[nodiscard]] gl::Defines handOutDefines(const OitPlan& plan);
void bindHandOut(const frame::PassContext& context, const OitPlan& plan);

}  // namespace macula::passes
