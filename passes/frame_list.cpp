// The one file that names every pass, in the order in which a frame runs them.
#include "passes/frame_list.h"

#include "passes/gbuffer_pass.h"
#include "passes/heatmap_pass.h"
#include "passes/lighting_pass.h"
#include "passes/lod/passes.h"
#include "passes/lod/resources.h"
#include "passes/oit/passes.h"
#include "passes/resources.h"
#include "passes/shadow_pass.h"
#include "passes/tonemap_pass.h"
#include "shared/oit_totals.h"

namespace macula::passes {

frame::FrameList makeFrameList(const RenderSettings& settings, const OitPlan& plan,
                               const LodPlan& lod) {
  std::vector<std::unique_ptr<frame::Pass>> passes;
  const auto add = [&](std::unique_ptr<frame::Pass> pass) { passes.push_back(std::move(pass)); };
  // Opaque
  add(std::make_unique<ShadowPass>(settings.shadow));
  add(std::make_unique<GBufferPass>());
  add(makeLodRatesPass(lod));
  add(makeLodShadePass(lod));
  add(makeLodReconstructPass(lod));
  add(makeLodHolesPass(lod));
  add(std::make_unique<LightingPass>(lod));
  // Transparent, over the opaque image or apart from it
  add(makeLodDepthPass(lod));
  add(makeBlendPass(plan));
  add(makeWeightedPass(plan));
  add(makeWeightedResolvePass(plan));
  add(makePeelPass(plan));
  add(makeCountPass(plan));
  add(makeCountColorsPass(plan));
  add(makePredictPass(plan));
  add(makeImportancePass(plan));
  add(makeExtentPass(plan));
  add(makeSlicesPass(plan));
  add(makeCoveredTilesPass(plan));
  add(makeNetworkPass(plan));
  add(makeNetworkImportancePass(plan));
  add(makeReservePass(plan));
  add(makeHistogramPass(plan));
  add(makeOneKPass(plan));
  add(makeAllocatePass(plan));
  add(makeCoveredSamplesPass(plan));
  for (int round = 0; round < MULTIPLIER_ROUNDS; ++round) {
    add(makeMultiplierRoundPass(plan, round));
  }
  add(makeMarginalDemandPass(plan));
  add(makeDemandPass(plan));
  add(makePrefixPass(plan, false));
  add(makePrefixPass(plan, true));
  add(makeSharePass(plan));
  add(makeOccupancyPass(plan));
  add(makeCullDepthPass(plan));
  add(makeAtomicKeysPass(plan));
  add(makeRoutedPass(plan));
  add(makeCapturePass(plan));
  add(makeResolvePass(plan));
  add(makeLodTransparencyPass(lod));
  // What is shown
  add(std::make_unique<TonemapPass>(settings.tonemap));
  add(std::make_unique<HeatmapPass>(settings.heatmap, plan, lod, settings.tonemap.ssaa));
  // What is reported
  std::vector<std::unique_ptr<frame::Pass>> reportPasses;
  reportPasses.push_back(makeReportCountPass(plan));
  reportPasses.push_back(makeStatisticsPass(plan));
  return {std::move(passes),
          // The G-buffer is whole; the lighting of unlit surfaces leaves normals unread.
          {&kDisplayColor, &kHeatmapColor, &kLinearColor, &kNormal, &kOitTotals, &kLodTotals,
           &kOitStatistics},
          {&kFragmentKeys, &kFragmentColors},  // read back fragment by fragment
          std::move(reportPasses)};
}

frame::FrameInputs inputsOf(const scene::SceneFacts& facts) {
  frame::FrameInputs inputs;
  inputs.facts = facts;
  return inputs;
}

}  // namespace macula::passes
