// Every pass of transparency. Each makes work of the plan's method and options, or has none;
// passes/frame_list.cpp names their order, and README.md walks a pixel's data through them.
#pragma once

#include <memory>

#include "engine/frame/pass.h"
#include "passes/oit/plan.h"

namespace macula::passes {

using OitPassPtr = std::unique_ptr<frame::Pass>;

// blending/: methods that store no fragments.
[[nodiscard]] OitPassPtr makeBlendPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeWeightedPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeWeightedResolvePass(const OitPlan& plan);

// peeling/
[[nodiscard]] OitPassPtr makePeelPass(const OitPlan& plan);

// capture/: how many fragments a pixel has.
[[nodiscard]] OitPassPtr makeCountPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeCountColorsPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makePredictPass(const OitPlan& plan);

// published/: importance and slots as Vasilakis et al. 2017 state them.
[[nodiscard]] OitPassPtr makeImportancePass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeReservePass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeHistogramPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeOneKPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeAllocatePass(const OitPlan& plan);

// learned/
[[nodiscard]] OitPassPtr makeExtentPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeNetworkPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeNetworkImportancePass(const OitPlan& plan);

// utility/: slots by marginal utility.
[[nodiscard]] OitPassPtr makeSlicesPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeCoveredTilesPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeCoveredSamplesPass(const OitPlan& plan);
/// @param round 0 or 1: brackets the Lagrange multiplier, then narrows the bracket
[[nodiscard]] OitPassPtr makeMultiplierRoundPass(const OitPlan& plan, int round);
[[nodiscard]] OitPassPtr makeMarginalDemandPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeDemandPass(const OitPlan& plan);
/// @param rows prefix sums over the rows of strips; else along each row
[[nodiscard]] OitPassPtr makePrefixPass(const OitPlan& plan, bool rows);
[[nodiscard]] OitPassPtr makeSharePass(const OitPlan& plan);

// culling/
[[nodiscard]] OitPassPtr makeOccupancyPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeCullDepthPass(const OitPlan& plan);

// routing/
[[nodiscard]] OitPassPtr makeRoutedPass(const OitPlan& plan);

// capture/: fragments into their slots, and slots into the image.
[[nodiscard]] OitPassPtr makeAtomicKeysPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeCapturePass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeResolvePass(const OitPlan& plan);

// For the report: run after the frame's time has been taken.
[[nodiscard]] OitPassPtr makeReportCountPass(const OitPlan& plan);
[[nodiscard]] OitPassPtr makeStatisticsPass(const OitPlan& plan);

}  // namespace macula::passes
