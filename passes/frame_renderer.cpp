#include "passes/frame_renderer.h"

#include <algorithm>
#include <limits>

#include "engine/core/error.h"
#include "engine/frame/pass_context.h"
#include "engine/scene/camera_path.h"
#include "engine/scene/view.h"
#include "passes/frame_list.h"
#include "passes/oit/oit_pass.h"
#include "shared/bindings.h"
#include "shared/frame_constants.h"

namespace macula::passes {

using frame::Resource;

namespace {

/// N_limit before anything was counted: the paper's own range is 20 to 30 (Vasilakis 2017, 3.2).
constexpr float kFirstLayerLimit = 30.0F;
/// First size of an exact method's pool, in slots a sample; it grows to what the frames need.
constexpr std::uint64_t kFirstSlotsPerSample = 2;

/// Fragments that heap sort and composition handle in 65,535 loop iterations: n log2 n + 3 n.
constexpr std::uint32_t kDeepestBoundedSort = 4096;
/// The same for the merge sort of a list: 2 n log2 n.
constexpr std::uint32_t kDeepestBoundedMerge = 2048;

/// Room to spare when the pool of an exact method grows, so that a slow approach does not draw
/// every frame twice.
std::uint32_t grown(std::uint32_t needed) {
  return needed + needed / 8;
}

SyncMode syncByName(const std::string& name) {
  for (const SyncMode mode :
       {SyncMode::Interlock, SyncMode::Spinlock, SyncMode::Ordered, SyncMode::None}) {
    if (name == nameOf(mode)) return mode;
  }
  return SyncMode::Auto;
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
      list_(makeFrameList(settings, plan_)),
      timer_(machine.time.source),
      constants_("frame constants", sizeof(shader::FrameConstants)) {
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

void FrameRenderer::setScene(const scene::GpuScene& scene) {
  inputs_.gpu = &scene;
  inputs_.facts = scene.facts();
  if (!transparencyShown_) inputs_.facts.transparentTriangles = 0;  // every pass asks for these
  deepestSeen_ = 0;
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
        "{}x{} with {} samples per axis is more than this GPU's {} texels a side; lower "
        "--size or --ssaa",
        outputSize.x, outputSize.y, settings_.tonemap.ssaa, machine_.capabilities.maxTextureSize);
  }
  inputs_.outputSize = outputSize;
  settingsChanged();
}

void FrameRenderer::settingsChanged() {
  prepared_ = false;
  historyUsable_ = false;
}

void FrameRenderer::sizePool(std::uint32_t slots) {
  plan_.slots = std::max(1U, slots);
  // 16-byte fragments keep key and colour apart; packed ones are all key.
  resources_.setBufferBytes(Resource::FragmentKeys, plan_.slots * kFragmentBytes / 2);
  resources_.setBufferBytes(Resource::FragmentColors, plan_.slots * kFragmentBytes / 2);
  resources_.setBufferBytes(Resource::FragmentLinks, plan_.slots * kLinkBytes);
}

void FrameRenderer::planRoutedSamples() {
  // Bytes are promised, so only numbers of samples that the GPU really makes are used.
  int best = 0;
  int least = 0;
  for (const int samples : machine_.capabilities.routableSamples) {
    if (samples <= static_cast<int>(plan_.layers)) best = std::max(best, samples);
    if (least == 0 || samples < least) least = samples;
  }
  if (best == 0) {
    failInput(
        "kb-stencil keeps a fragment in each sample, and {} has {} samples a pixel at the least; "
        "the budget gives {}; raise --k-ave or --oit-memory, or use kb-fixed",
        machine_.capabilities.renderer, least, plan_.layers);
  }
  plan_.layers = static_cast<std::uint32_t>(best);
  resources_.setMultisamples(best);
}

void FrameRenderer::planMethod(std::uint64_t samples) {
  const Method* before = plan_.method;
  plan_.method = &methodById(settings_.oit.method);
  plan_.options = settings_.oit;
  plan_.layers = static_cast<std::uint32_t>(settings_.oit.layers);
  const SyncMode wish = syncByName(settings_.oit.sync);
  plan_.sync = plan_.method->isRacy()
                   ? SyncMode::None
                   : chooseSync(wish, machine_.capabilities, machine_.ordered);
  plan_.budgetBytes.reset();
  constexpr double kMebi = 1024.0 * 1024.0;
  if (plan_.method->hasBudget()) {
    planBudget(plan_, samples);
    if (plan_.method->insertion == Insertion::StencilRouted) planRoutedSamples();
    sizePool(plan_.slots);
  } else if (plan_.method->grows() && settings_.oit.memoryMiB > 0.0) {
    // A cap instead of growth: what does not fit is counted, and the frame is flagged inexact.
    const std::uint64_t each =
        kFragmentBytes + (plan_.method->insertion == Insertion::Linked ? kLinkBytes : 0);
    plan_.budgetBytes = static_cast<std::uint64_t>(settings_.oit.memoryMiB * kMebi);
    if (*plan_.budgetBytes < each) {
      failInput("--oit-memory of {} bytes holds no fragment ({} bytes each); raise it, or 0",
                *plan_.budgetBytes, each);
    }
    sizePool(static_cast<std::uint32_t>(*plan_.budgetBytes / each));
  } else if (plan_.method->allocation == Allocation::Constant) {
    const std::uint64_t slots = plan_.layers * samples;
    if (slots > std::numeric_limits<std::uint32_t>::max()) {
      failInput(
          "{} slots for each of {} samples are more than can be addressed; lower "
          "--oit.layers or --size",
          plan_.layers, samples);
    }
    sizePool(static_cast<std::uint32_t>(slots));
  } else if (before != plan_.method || plan_.slots < samples * kFirstSlotsPerSample) {
    sizePool(static_cast<std::uint32_t>(samples * kFirstSlotsPerSample));
  }
}

void FrameRenderer::allocate() {
  try {
    list_.prepare(inputs_, resources_, machine_.programs,
                  machine_.capabilities.maxStorageBlockBytes);
  } catch (...) {
    // No frame may be drawn with a pool that is larger than its memory: the next one plans anew.
    prepared_ = false;
    plan_.slots = 0;
    throw;
  }
}

void FrameRenderer::prepare() {
  inputs_.displaySize = inputs_.outputSize * settings_.tonemap.ssaa;
  const auto samples = static_cast<std::uint64_t>(inputs_.displaySize.x) *
                       static_cast<std::uint64_t>(inputs_.displaySize.y);
  checkCombination(settings_.oit);
  plan_.importance = settings_.importance;
  plan_.seed = settings_.seed;
  plan_.factorMaps = needsFactors(settings_.heatmap.map);
  planMethod(samples);
  resources_.setBufferBytes(Resource::OitTotals, sizeof(shader::OitTotals));
  const glm::ivec2 size = inputs_.displaySize;
  const glm::ivec2 tiles = (size + plan_.importance.tile - 1) / plan_.importance.tile;
  const auto area = [](glm::ivec2 s) {
    return static_cast<std::size_t>(s.x) * static_cast<std::size_t>(s.y);
  };
  constexpr std::size_t kVectorBytes = 16;
  resources_.setFixedSize(Resource::TileDepth, tiles);
  resources_.setBufferBytes(
      Resource::SliceSums,
      area(tiles) * static_cast<std::size_t>(plan_.importance.slices) * kVectorBytes);
  resources_.setBufferBytes(
      Resource::StripSums,
      (area({(size.x + STRIP - 1) / STRIP, size.y}) + static_cast<std::size_t>(size.y)) *
          kVectorBytes);
  resources_.setBufferBytes(Resource::Occupancy, area(size) *
                                                     static_cast<std::size_t>(plan_.options.cullWords) *
                                                     sizeof(std::uint32_t));
  resources_.setBufferBytes(Resource::CountBins, COUNT_BINS * sizeof(std::uint32_t));
  resources_.setFixedSize(Resource::ShadowMap, glm::ivec2(settings_.shadow.size));
  resources_.setBackground(settings_.background);
  allocate();
  if (inputs_.facts.transparentTriangles > 0) statistics_.prepare(inputs_, machine_.programs);
  prepared_ = true;
}

void FrameRenderer::uploadConstants() {
  const glm::vec2 size(inputs_.displaySize);
  shader::FrameConstants c{};
  c.viewProjection = inputs_.view.viewProjection;
  c.inverseViewProjection = inputs_.view.inverseViewProjection;
  c.eye = glm::vec4(inputs_.view.camera.position, 1.0F);
  c.size = glm::vec4(size, 1.0F / size);
  // GL counts rows from the bottom, gaze from the top.
  c.gaze = glm::vec4(inputs_.gaze.x * size.x, (1.0F - inputs_.gaze.y) * size.y, 0.0F, 0.0F);
  c.background = glm::vec4(settings_.background, 1.0F);
  c.frame = glm::uvec4(inputs_.frameIndex, inputs_.historyValid ? 1U : 0U, settings_.seed, 0U);
  c.oit = glm::uvec4(plan_.layers, plan_.slots, priceStride(inputs_.displaySize),
                     plan_.options.cullWords);
  c.slices = glm::vec4(inputs_.view.camera.nearPlane, inputs_.view.camera.farPlane,
                       plan_.importance.slices, plan_.importance.tile);
  c.reprojection = lastViewProjection_ * inputs_.view.inverseViewProjection;
  constants_.upload(&c, sizeof(c));
  glBindBufferBase(GL_UNIFORM_BUFFER, UBO_FRAME, constants_.id());
}

shader::OitTotals FrameRenderer::runOnce() {
  uploadConstants();
  frame::PassContext context(inputs_, resources_);
  list_.run(context, timer_);
  shader::OitTotals totals{};
  if (resources_.has(Resource::OitTotals)) {
    resources_.buffer(Resource::OitTotals).download(&totals, sizeof(totals));
  }
  return totals;
}

FrameResult FrameRenderer::render(const scene::Camera& camera, glm::vec2 gaze, bool cut) {
  if (!prepared_) prepare();
  const glm::vec2 size(inputs_.displaySize);
  inputs_.view = scene::makeView(camera, size.x / size.y);
  inputs_.gaze = gaze;
  const bool jumped =
      lastCamera_ && scene::isCameraCut(*lastCamera_, camera, inputs_.gpu->bounds().radius());
  inputs_.historyValid = historyUsable_ && !cut && !jumped;
  plan_.layerLimit = settings_.importance.layerLimit > 0.0
                         ? static_cast<float>(settings_.importance.layerLimit)
                     : deepestSeen_ > 0 ? static_cast<float>(deepestSeen_)
                                        : kFirstLayerLimit;
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
  historyUsable_ = true;
  ++inputs_.frameIndex;
  return result;
}

FrameResult FrameRenderer::resultOf(const shader::OitTotals& totals) {
  FrameResult result;
  result.totalMs = timer_.totalMs() + extraMs_;
  result.passes = list_.times();
  result.lockFailures = totals.lockFailures;
  if (inputs_.facts.transparentTriangles == 0) {
    result.fragments = FragmentCounts{};
    result.exact = true;
  } else if (plan_.method->insertion != Insertion::Blended &&
             plan_.method->insertion != Insertion::Weighted) {
    countFragments(totals, result);
  }
  return result;
}

void FrameRenderer::countFragments(const shader::OitTotals& totals, FrameResult& result) {
  frame::PassContext context(inputs_, resources_);
  const shader::OitStatistics s = statistics_.measure(context);
  const Method& method = *plan_.method;
  FragmentCounts counts;
  counts.generated = s.generated;
  counts.stored = s.stored;
  if (method.insertion == Insertion::Linked) counts.stored = std::min(totals.cursor, plan_.slots);
  // A tail is thought to hold all that is not stored; what was given up at a lock never reached it.
  const std::uint64_t left = counts.generated - counts.stored;
  counts.merged = std::min<std::uint64_t>(
      s.merged, left - std::min<std::uint64_t>(left, totals.lockFailures));
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
  const bool sortable = (method.insertion != Insertion::Appended &&
                         method.insertion != Insertion::Linked) ||
                        machine_.capabilities.maxLoopIterations == 0 || s.countMax <= deepest;
  const bool keepsOrder = plan_.sync != SyncMode::None || method.insertion != Insertion::Sorted;
  result.exact = counts.lost == 0 && counts.merged == 0 && keepsOrder && sortable &&
                 !plan_.packed() && method.insertion != Insertion::StencilRouted;
}

void FrameRenderer::readDisplay(std::vector<std::uint8_t>& rgb) const {
  readRgb(resources_.texture(Resource::DisplayColor), GL_UNSIGNED_BYTE, rgb);
}

void FrameRenderer::readLinear(std::vector<float>& rgb) const {
  readRgb(resources_.texture(Resource::LinearColor), GL_FLOAT, rgb);
}

}  // namespace macula::passes
