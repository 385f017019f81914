// What the shader of a network of importance reads (shaders/oit/network.comp): for the pass, and
// for those who read its features back.
#pragma once

#include "passes/oit/oit_pass.h"

namespace macula::passes {

/// All but the totals, which the pass reads to walk its list.
void declareNetworkInputs(frame::PassDeclaration& d, const OitPlan& plan);
void bindNetworkInputs(const frame::PassContext& context, const OitPlan& plan);

}  // namespace macula::passes
