// What the shader of a network of importance reads (shaders/oit/network.comp): for the pass that
// evaluates it, and for the reader of its features.
#pragma once

#include "engine/frame/binding.h"
#include "passes/oit/plan.h"

namespace macula::passes {

/// Rows, but for the totals.
void networkInputRows(frame::PassDeclaration& d, const OitPlan& plan);
/// Uniforms, of the program in use.
void setNetworkUniforms(const OitPlan& plan);

}  // namespace macula::passes
