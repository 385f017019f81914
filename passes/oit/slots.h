// How a budget, a setting or the last frames become slots: one function per kind of allocation, for
// the rows of the method table.
#pragma once

#include "passes/oit/plan.h"

namespace macula::passes {

/// A pool that pixels share under a budget.
/// @throws InputError where the budget holds no fragment, or more than shaders can address
void planBudgetPool(OitPlan& plan, const PlanInputs& in);

/// The same number of slots for each sample, as many as the budget gives.
/// @throws InputError where that is none, or less than a tail needs
void planBudgetLayers(OitPlan& plan, const PlanInputs& in);

/// The same, rounded down to a number of multisample slots that the device has.
/// @throws InputError where the budget gives less than the device's least
void planBudgetSamples(OitPlan& plan, const PlanInputs& in);

/// oit.layers slots for each sample.
/// @throws InputError where they are more than can be addressed
void planSettingLayers(OitPlan& plan, const PlanInputs& in);

/// A pool that begins with some slots a sample and grows to what the frames need (growPool()); with
/// `--oit-memory`, one of that many bytes that does not grow.
/// @throws InputError where those bytes hold no fragment
void planGrowingPool(OitPlan& plan, const PlanInputs& in);

/// Whether the frame asked for more slots than a pool that grows has.
[[nodiscard]] bool needsLargerPool(const OitPlan& plan, std::uint32_t asked);
/// Makes room for what was asked, and some to spare.
void growPool(OitPlan& plan, std::uint32_t asked);

}  // namespace macula::passes
