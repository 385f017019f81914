// FrameRenderer: one frame, and what is told about it.
#include <algorithm>

#include "engine/scene/camera_path.h"
#include "engine/scene/view.h"
#include "passes/frame_renderer.h"
#include "passes/lod/resources.h"
#include "passes/oit/slots.h"
#include "shared/lod_totals.h"

namespace macula::passes {
namespace {

/// N_limit before anything was counted: the paper's own range is 20 to 30 (Vasilakis 2017, 3.2).
constexpr float kFirstLayerLimit = 30.0F;

// Passes whose work follows 1 / r^2.
constexpr std::string_view kShadePass = "lod.shade";
constexpr std::string_view kTransparencyPasses = "oit.";
/// Shades at full rate, until anything asks for less.
constexpr std::string_view kLightingPass = "lighting";

/// The sums that a buffer holds; zero where no pass makes them.
template <typename T>
T totalsIn(const frame::FrameResources& resources, const frame::Resource& buffer) {
  T totals{};
  if (resources.has(buffer)) resources.buffer(buffer).download(&totals, sizeof(totals));
  return totals;
}

}  // namespace

frame::PassContext FrameRenderer::passContext() {
  return {inputs_, resources_, list_.barriers(), constants_.ids()};
}

void FrameRenderer::beginFrame(const scene::Camera& camera, const gaze::PointOfInterest& gaze,
                               bool cut) {
  const glm::vec2 size(inputs_.displaySize);
  inputs_.view = scene::makeView(camera, size.x / size.y);
  inputs_.gpu->chooseLights(camera, size.x / size.y);
  inputs_.gaze = gaze;
  cut_ = cut;
  const bool jumped = history_.camera &&
                      scene::isCameraCut(*history_.camera, camera, inputs_.gpu->bounds().radius());
  inputs_.historyValid = history_.usable && !cut && !jumped;
  planFrame(lod_, settings_.lod, settings_.foveation, inputs_, settings_.tonemap.ssaa);
  lod_.load = shadingLoad_;
  plan_.layerLimit = settings_.importance.layerLimit > 0.0
                         ? static_cast<float>(settings_.importance.layerLimit)
                     : deepestSeen_ > 0 ? static_cast<float>(deepestSeen_)
                                        : kFirstLayerLimit;
  plan_.size = lod_.transparencySize();
  plan_.historyValid = inputs_.historyValid && plan_.size == history_.transparencySize;
  planFrameSlots(plan_, inputs_.controls.layerShare);
  heatmapRange_ = heatmapRange(settings_.heatmap, plan_);
}

shader::OitTotals FrameRenderer::runOnce() {
  constants_.upload({inputs_, plan_, lod_, settings_.background, history_.viewProjection});
  frame::PassContext context = passContext();
  context.bindConstants(frame::Raster::Image);
  inputs_.gpu->bindLights();  // at bindings that no pass uses otherwise
  list_.run(context, timer_);
  return totalsIn<shader::OitTotals>(resources_, kOitTotals);
}

FrameResult FrameRenderer::render(const scene::Camera& camera, const gaze::PointOfInterest& gaze,
                                  bool cut) {
  if (unfinished_) restart();
  unfinished_ = true;
  prepareForReducedRate();
  if (!prepared_) prepare();
  beginFrame(camera, gaze, cut);
  shader::OitTotals totals = runOnce();
  double givenUpMs = 0.0;
  int recaptures = 0;
  while (needsLargerPool(plan_, totals.cursor)) {
    givenUpMs += timer_.totalMs();
    growPool(plan_, totals.cursor);
    allocate();
    totals = runOnce();
    ++recaptures;
  }
  FrameResult result = resultOf(totals);
  result.totalMs = timer_.totalMs() + givenUpMs;
  result.recaptures = recaptures;
  leaveHistory(camera);
  unfinished_ = false;
  return result;
}

void FrameRenderer::leaveHistory(const scene::Camera& camera) {
  history_ = {.camera = camera,
              .viewProjection = inputs_.view.viewProjection,
              .transparencySize = plan_.size,
              .usable = true};
  ++inputs_.frameIndex;
  ++steps_.frames;
}

FrameResult FrameRenderer::resultOf(const shader::OitTotals& totals) {
  FrameResult result;
  result.passes = list_.times();
  for (const frame::PassTime& pass : result.passes) {
    if (isResizable(pass.name)) result.resizableMs += pass.ms;
  }
  result.resizeFactor = lod_.resize;
  result.shading = shadingCounts();
  const FragmentReport report = fragmentReport(totals);
  result.fragments = report.fragments;
  result.layers = report.layers;
  result.deepest = report.deepest;
  result.tailSlots = report.tailSlots;
  result.exact = report.exact;
  result.lockFailures = totals.lockFailures;
  return result;
}

bool FrameRenderer::isResizable(std::string_view pass) const {
  if (lod_.canResizeTransparency && pass.starts_with(kTransparencyPasses)) return true;
  return lod_.canResizeShading && pass == (lod_.wanted ? kShadePass : kLightingPass);
}

ShadingCounts FrameRenderer::shadingCounts() const {
  const auto area = [](glm::ivec2 size) {
    return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
  };
  const std::uint64_t pixels = area(inputs_.displaySize);
  ShadingCounts counts{
      .pixels = pixels, .shaded = lod_.wanted ? area(lod_.texels) : pixels, .holes = 0};
  if (!lod_.wanted || lod_.fullRate()) return counts;
  const auto totals = totalsIn<shader::LodTotals>(resources_, kLodTotals);
  if (lod_.foveated) counts.shaded = totals.shaded;
  counts.holes = totals.dispatches[LOD_RATES].w;
  counts.shaded += counts.holes;
  return counts;
}

FragmentReport FrameRenderer::fragmentReport(const shader::OitTotals& totals) {
  FragmentReport report;
  if (inputs_.facts.transparentTriangles == 0) {
    report.fragments = FragmentCounts{};
    report.exact = true;
    return report;
  }
  if (!plan_.method->insertion.counted) return report;
  frame::PassContext context = passContext();
  list_.runReport(context);
  report = reportOf(plan_, totalsIn<shader::OitStatistics>(resources_, kOitStatistics), totals,
                    device_.capabilities);
  deepestSeen_ = std::max(deepestSeen_, report.deepest);
  plan_.largestLayers = report.largestLayers;
  return report;
}

}  // namespace macula::passes
