// The one file that names every pass, in the order in which a frame runs them.
#include "passes/frame_list.h"

#include "passes/gbuffer_pass.h"
#include "passes/heatmap_pass.h"
#include "passes/lighting_pass.h"
#include "passes/lod/depth_pass.h"
#include "passes/lod/holes_pass.h"
#include "passes/lod/rates_pass.h"
#include "passes/lod/reconstruct_pass.h"
#include "passes/lod/shade_pass.h"
#include "passes/lod/transparency_pass.h"
#include "passes/oit/allocate_pass.h"
#include "passes/oit/atomic_keys_pass.h"
#include "passes/oit/bids_pass.h"
#include "passes/oit/blend_pass.h"
#include "passes/oit/capture_pass.h"
#include "passes/oit/count_colors_pass.h"
#include "passes/oit/count_pass.h"
#include "passes/oit/covered_pass.h"
#include "passes/oit/cull_depth_pass.h"
#include "passes/oit/demand_pass.h"
#include "passes/oit/extent_pass.h"
#include "passes/oit/histogram_pass.h"
#include "passes/oit/importance_pass.h"
#include "passes/oit/network_importance_pass.h"
#include "passes/oit/network_pass.h"
#include "passes/oit/occupancy_pass.h"
#include "passes/oit/one_k_pass.h"
#include "passes/oit/peel_pass.h"
#include "passes/oit/predict_pass.h"
#include "passes/oit/prefix_pass.h"
#include "passes/oit/price_pass.h"
#include "passes/oit/reserve_pass.h"
#include "passes/oit/resolve_pass.h"
#include "passes/oit/routed_pass.h"
#include "passes/oit/share_pass.h"
#include "passes/oit/slices_pass.h"
#include "passes/oit/weighted_pass.h"
#include "passes/oit/weighted_resolve_pass.h"
#include "passes/shadow_pass.h"
#include "passes/tonemap_pass.h"
#include "shared/oit_totals.h"

namespace macula::passes {

using frame::Resource;

frame::FrameList makeFrameList(const RenderSettings& settings, const OitPlan& plan,
                               const LodPlan& lod) {
  std::vector<std::unique_ptr<frame::Pass>> passes;
  // Opaque
  passes.push_back(std::make_unique<ShadowPass>(settings.shadow));
  passes.push_back(std::make_unique<GBufferPass>());
  passes.push_back(std::make_unique<LodRatesPass>(lod));
  passes.push_back(std::make_unique<LodShadePass>(lod));
  passes.push_back(std::make_unique<LodReconstructPass>(lod));
  passes.push_back(std::make_unique<LodHolesPass>(lod));
  passes.push_back(std::make_unique<LightingPass>(lod));
  // Transparent, over the opaque image or apart from it
  passes.push_back(std::make_unique<LodDepthPass>(lod));
  passes.push_back(std::make_unique<BlendPass>(plan));
  passes.push_back(std::make_unique<WeightedPass>(plan));
  passes.push_back(std::make_unique<WeightedResolvePass>(plan));
  passes.push_back(std::make_unique<PeelPass>(plan));
  passes.push_back(std::make_unique<CountPass>(plan));
  passes.push_back(std::make_unique<CountColorsPass>(plan));
  passes.push_back(std::make_unique<PredictPass>(plan));
  passes.push_back(std::make_unique<ImportancePass>(plan));
  passes.push_back(std::make_unique<ExtentPass>(plan));
  passes.push_back(std::make_unique<SlicesPass>(plan));
  passes.push_back(std::make_unique<CoveredPass>(plan, LIST_OF_TILES));
  passes.push_back(std::make_unique<NetworkPass>(plan));
  passes.push_back(std::make_unique<NetworkImportancePass>(plan));
  passes.push_back(std::make_unique<ReservePass>(plan));
  passes.push_back(std::make_unique<HistogramPass>(plan));
  passes.push_back(std::make_unique<OneKPass>(plan));
  passes.push_back(std::make_unique<AllocatePass>(plan));
  passes.push_back(std::make_unique<CoveredPass>(plan, LIST_OF_SAMPLES));
  for (int round = 0; round < PRICE_ROUNDS; ++round) {
    passes.push_back(std::make_unique<PricePass>(plan, round));
  }
  passes.push_back(std::make_unique<BidsPass>(plan));
  passes.push_back(std::make_unique<DemandPass>(plan));
  passes.push_back(std::make_unique<PrefixPass>(plan, false));
  passes.push_back(std::make_unique<PrefixPass>(plan, true));
  passes.push_back(std::make_unique<SharePass>(plan));
  passes.push_back(std::make_unique<OccupancyPass>(plan));
  passes.push_back(std::make_unique<CullDepthPass>(plan));
  passes.push_back(std::make_unique<AtomicKeysPass>(plan));
  passes.push_back(std::make_unique<RoutedPass>(plan));
  passes.push_back(std::make_unique<CapturePass>(plan));
  passes.push_back(std::make_unique<ResolvePass>(plan));
  passes.push_back(std::make_unique<LodTransparencyPass>(lod));
  // What is shown
  passes.push_back(std::make_unique<TonemapPass>(settings.tonemap));
  passes.push_back(
      std::make_unique<HeatmapPass>(settings.heatmap, plan, lod, settings.tonemap.ssaa));
  return {std::move(passes),
          {Resource::DisplayColor, Resource::HeatmapColor, Resource::LinearColor,
           Resource::OitTotals, Resource::LodTotals}};
}

frame::FrameInputs inputsOf(const scene::SceneFacts& facts) {
  frame::FrameInputs inputs;
  inputs.facts = facts;
  return inputs;
}

}  // namespace macula::passes
