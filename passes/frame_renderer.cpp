#include "passes/frame_renderer.h"

#include <algorithm>

#include "engine/core/error.h"
#include "engine/core/plural.h"
#include "engine/scene/camera_path.h"
#include "engine/scene/view.h"
#include "passes/frame_list.h"
#include "shared/lod_totals.h"

namespace macula::passes {

using frame::Resource;

namespace {

/// N_limit before anything was counted: the paper's own range is 20 to 30 (Vasilakis 2017, 3.2).
constexpr float kFirstLayerLimit = 30.0F;

/// Whose work follows 1 / r^2: opaque and transparent; the last until anything asks for less than
/// full rate.
constexpr std::string_view kShadePass = "lod.shade";
constexpr std::string_view kTransparencyPasses = "oit.";
constexpr std::string_view kLightingPass = "lighting";

/// Fragments that heap sort and composition handle in 65,535 loop iterations: n log2 n + 3 n.
constexpr std::uint32_t kDeepestBoundedSort = 4096;
/// The same for the merge sort of a list: 2 n log2 n.
constexpr std::uint32_t kDeepestBoundedMerge = 2048;

/// Room to spare when the pool of an exact method grows, so that a slow approach does not draw
/// every frame twice.
std::uint32_t grown(std::uint32_t needed) {
  return needed + needed / 8;
}

/// Red, green and blue of a texture, rows from the top.
template <typename T>
void readRgb(const gl::Texture& texture, GLenum type, std::vector<T>& rgb) {
  const auto row = static_cast<std::ptrdiff_t>(texture.width()) * 3;
  rgb.resize(static_cast<std::size_t>(row) * static_cast<std::size_t>(texture.height()));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  glGetTextureImage(texture.id(), 0, GL_RGB, type, static_cast<GLsizei>(rgb.size() * sizeof(T)),
                    rgb.data());
  // GL counts rows from the bottom.
  for (std::ptrdiff_t y = 0; y < texture.height() / 2; ++y) {
    const auto mirrored = texture.height() - 1 - y;
    std::swap_ranges(rgb.begin() + y * row, rgb.begin() + (y + 1) * row,
                     rgb.begin() + mirrored * row);
  }
}

}  // namespace

FrameRenderer::FrameRenderer(const RenderSettings& settings, Machine& machine)
    : settings_(settings),
      machine_(machine),
      plan_{.method = &methodById(settings.oit.method)},
      statistics_(plan_),
      list_(makeFrameList(settings, plan_, lod_)),
      timer_(machine.time.source),
      constants_("frame constants", sizeof(shader::FrameConstants)),
      resizedConstants_("frame constants of resized transparency", sizeof(shader::FrameConstants)) {
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

void FrameRenderer::setScene(const scene::GpuScene& scene) {
  inputs_.gpu = &scene;
  inputs_.facts = scene.facts();
  if (!transparencyShown_) inputs_.facts.transparentTriangles = 0;  // every pass asks for these
  deepestSeen_ = 0;
  ++steps_.scenes;
  settingsChanged();
}

void FrameRenderer::showTransparency(bool shown) {
  transparencyShown_ = shown;
  if (inputs_.gpu != nullptr) setScene(*inputs_.gpu);
}

void FrameRenderer::resize(glm::ivec2 outputSize) {
  const int side = std::max(outputSize.x, outputSize.y) * settings_.tonemap.ssaa;
  if (side > machine_.capabilities.maxTextureSize) {
    failInput(
        "{}x{} with {} per axis is more than this GPU's {} texels a side; lower "
        "--size or --ssaa",
        outputSize.x, outputSize.y,
        counted(static_cast<std::uint64_t>(settings_.tonemap.ssaa), "sample"),
        machine_.capabilities.maxTextureSize);
  }
  inputs_.outputSize = outputSize;
  settingsChanged();
}

void FrameRenderer::settingsChanged() {
  prepared_ = false;
  historyUsable_ = false;
  ++steps_.resets;
}

void FrameRenderer::setLevers(const frame::Levers& levers) {
  inputs_.levers = levers;
}

void FrameRenderer::readyForLevers() {
  if (mayResize_ || inputs_.levers.resize <= 1.0F) return;
  // The first time, the passes are made ready; nothing that a frame remembers depends on it.
  mayResize_ = true;
  const bool ready =
      lod_.wanted == lod_.canResizeShading && lod_.transparency == lod_.canResizeTransparency;
  if (!ready) prepared_ = false;
}

bool FrameRenderer::canResize() const {
  if (inputs_.gpu == nullptr) return true;
  LodPlan plan;
  planLod(plan, settings_.lod, settings_.foveation, inputs_.facts, true);
  return plan.canResizeShading || plan.canResizeTransparency;
}

void FrameRenderer::setShadingLoad(int times) {
  shadingLoad_ = times;
}

void FrameRenderer::restart() {
  lastTransparencySize_ = {};
  plan_ = {.method = &methodById(settings_.oit.method)};
  list_ = makeFrameList(settings_, plan_, lod_);
  resources_ = {};
  inputs_.frameIndex = 0;
  deepestSeen_ = 0;
  mayResize_ = false;
  lastCamera_.reset();
  lastViewProjection_ = glm::mat4(1.0F);
  prepared_ = false;
  historyUsable_ = false;
  unfinished_ = false;
  ++steps_.restarts;
}

frame::PassContext FrameRenderer::passContext() {
  return {inputs_, resources_, {constants_.id(), resizedConstants_.id()}};
}

shader::OitTotals FrameRenderer::runOnce() {
  uploadConstants();
  frame::PassContext context = passContext();
  context.bindConstants(frame::Raster::Image);
  list_.run(context, timer_);
  shader::OitTotals totals{};
  if (resources_.has(Resource::OitTotals)) {
    resources_.buffer(Resource::OitTotals).download(&totals, sizeof(totals));
  }
  return totals;
}

FrameResult FrameRenderer::render(const scene::Camera& camera, const gaze::PointOfInterest& gaze,
                                  bool cut) {
  if (unfinished_) restart();
  unfinished_ = true;
  readyForLevers();
  if (!prepared_) prepare();
  const glm::vec2 size(inputs_.displaySize);
  inputs_.view = scene::makeView(camera, size.x / size.y);
  inputs_.gpu->chooseLights(camera, size.x / size.y);
  inputs_.gaze = gaze;
  cut_ = cut;
  const bool jumped =
      lastCamera_ && scene::isCameraCut(*lastCamera_, camera, inputs_.gpu->bounds().radius());
  inputs_.historyValid = historyUsable_ && !cut && !jumped;
  plan_.layerLimit = settings_.importance.layerLimit > 0.0
                         ? static_cast<float>(settings_.importance.layerLimit)
                     : deepestSeen_ > 0 ? static_cast<float>(deepestSeen_)
                                        : kFirstLayerLimit;
  planFrame(lod_, settings_.lod, settings_.foveation, inputs_, settings_.tonemap.ssaa);
  lod_.load = shadingLoad_;
  planTransparency();
  heatmapRange_ = heatmapRange(settings_.heatmap, plan_);
  shader::OitTotals totals = runOnce();
  extraMs_ = 0.0;
  int recaptures = 0;
  while (plan_.method->grows() && !plan_.budgetBytes && totals.cursor > plan_.slots) {
    extraMs_ += timer_.totalMs();
    sizePool(grown(totals.cursor));
    allocate();
    totals = runOnce();
    ++recaptures;
  }
  FrameResult result = resultOf(totals);
  result.recaptures = recaptures;
  deepestSeen_ = std::max(deepestSeen_, result.deepest);
  lastViewProjection_ = inputs_.view.viewProjection;
  lastCamera_ = camera;
  lastTransparencySize_ = plan_.size;
  historyUsable_ = true;
  ++inputs_.frameIndex;
  ++steps_.frames;
  unfinished_ = false;
  return result;
}

FrameResult FrameRenderer::resultOf(const shader::OitTotals& totals) {
  FrameResult result;
  result.totalMs = timer_.totalMs() + extraMs_;
  result.passes = list_.times();
  for (const frame::PassTime& pass : result.passes) {
    if (isResizable(pass.name)) result.resizableMs += pass.ms;
  }
  result.lockFailures = totals.lockFailures;
  countShading(result);
  if (inputs_.facts.transparentTriangles == 0) {
    result.fragments = FragmentCounts{};
    result.exact = true;
  } else if (plan_.method->insertion != Insertion::Blended &&
             plan_.method->insertion != Insertion::Weighted) {
    countFragments(totals, result);
  }
  return result;
}

bool FrameRenderer::isResizable(std::string_view pass) const {
  if (lod_.canResizeTransparency && pass.starts_with(kTransparencyPasses)) return true;
  return lod_.canResizeShading && pass == (lod_.wanted ? kShadePass : kLightingPass);
}

void FrameRenderer::countShading(FrameResult& result) const {
  const auto area = [](glm::ivec2 size) {
    return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
  };
  result.resizeFactor = lod_.resize;
  const std::uint64_t pixels = area(inputs_.displaySize);
  result.shading = {
      .pixels = pixels, .shaded = lod_.wanted ? area(lod_.texels) : pixels, .holes = 0};
  if (!lod_.wanted || lod_.fullRate()) return;
  shader::LodTotals totals{};
  resources_.buffer(Resource::LodTotals).download(&totals, sizeof(totals));
  if (lod_.foveated) result.shading.shaded = totals.shaded;
  result.shading.holes = totals.dispatches[LOD_RATES].w;
  result.shading.shaded += result.shading.holes;
}

void FrameRenderer::countFragments(const shader::OitTotals& totals, FrameResult& result) {
  frame::PassContext context = passContext();
  const shader::OitStatistics s = statistics_.measure(context);
  const Method& method = *plan_.method;
  FragmentCounts counts;
  counts.generated = s.generated;
  counts.stored = s.stored;
  if (method.insertion == Insertion::Linked) counts.stored = std::min(totals.cursor, plan_.slots);
  // A tail is thought to hold all that is not stored; what was given up at a lock never reached it.
  const std::uint64_t left = counts.generated - counts.stored;
  counts.merged =
      std::min<std::uint64_t>(s.merged, left - std::min<std::uint64_t>(left, totals.lockFailures));
  counts.lost = counts.generated - counts.stored - counts.merged;
  result.fragments = counts;
  result.deepest = s.countMax;
  if (plan_.tailInSlot()) result.tailSlots = std::uint64_t{s.tails} * plan_.tailSlots();
  plan_.largestLayers = s.kMax;
  if (s.covered > 0 && method.stores() && method.insertion != Insertion::Linked) {
    result.layers =
        LayerStatistics{~s.kMinInverted, s.kMax, static_cast<double>(s.slots) / s.covered};
  }
  // Where the device bounds loops, the sort of a deeper pixel would be cut short.
  const std::uint32_t deepest =
      method.insertion == Insertion::Linked ? kDeepestBoundedMerge : kDeepestBoundedSort;
  const bool sortable =
      (method.insertion != Insertion::Appended && method.insertion != Insertion::Linked) ||
      machine_.capabilities.maxLoopIterations == 0 || s.countMax <= deepest;
  const bool keepsOrder = plan_.sync != SyncMode::None || method.insertion != Insertion::Sorted;
  result.exact = counts.lost == 0 && counts.merged == 0 && keepsOrder && sortable &&
                 !plan_.packed() && !plan_.resized() &&
                 method.insertion != Insertion::StencilRouted;
}

void FrameRenderer::readDisplay(std::vector<std::uint8_t>& rgb) const {
  readRgb(resources_.texture(Resource::DisplayColor), GL_UNSIGNED_BYTE, rgb);
}

const gl::Texture& FrameRenderer::shownTexture() const {
  const bool mapped = resources_.has(Resource::HeatmapColor);
  return resources_.texture(mapped ? Resource::HeatmapColor : Resource::DisplayColor);
}

void FrameRenderer::readShown(std::vector<std::uint8_t>& rgb) const {
  readRgb(shownTexture(), GL_UNSIGNED_BYTE, rgb);
}

std::optional<image::Legend> FrameRenderer::legend() const {
  if (!resources_.has(Resource::HeatmapColor)) return std::nullopt;
  return legendOf(settings_.heatmap, heatmapRange_);
}

void FrameRenderer::readLinear(std::vector<float>& rgb) const {
  readRgb(resources_.texture(Resource::LinearColor), GL_FLOAT, rgb);
}

}  // namespace macula::passes
