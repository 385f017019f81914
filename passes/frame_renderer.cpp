#include "passes/frame_renderer.h"

#include <algorithm>

#include "engine/core/error.h"
#include "engine/frame/pass_context.h"
#include "engine/scene/camera_path.h"
#include "engine/scene/view.h"
#include "passes/frame_list.h"
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
  resources_.setBufferBytes(Resource::FragmentKeys, plan_.slots * kFragmentBytes / 2);
  resources_.setBufferBytes(Resource::FragmentColors, plan_.slots * kFragmentBytes / 2);
}

void FrameRenderer::prepare() {
  inputs_.displaySize = inputs_.outputSize * settings_.tonemap.ssaa;
  const auto samples = static_cast<std::uint64_t>(inputs_.displaySize.x) *
                       static_cast<std::uint64_t>(inputs_.displaySize.y);
  const Method* before = plan_.method;
  plan_.method = &methodById(settings_.oit.method);
  plan_.sync = chooseSync(syncByName(settings_.oit.sync), machine_.capabilities, machine_.ordered);
  plan_.importance = settings_.importance;
  plan_.seed = settings_.seed;
  plan_.factorMaps = needsFactors(settings_.heatmap.map);
  plan_.budgetBytes.reset();
  if (plan_.method->hasBudget()) {
    planBudget(plan_, settings_.oit, samples);
    sizePool(plan_.slots);
  } else if (before != plan_.method || plan_.slots < samples) {
    sizePool(static_cast<std::uint32_t>(samples * kFirstSlotsPerSample));
  }
  resources_.setBufferBytes(Resource::OitTotals, sizeof(shader::OitTotals));
  resources_.setFixedSize(Resource::ShadowMap, glm::ivec2(settings_.shadow.size));
  resources_.setBackground(settings_.background);
  list_.prepare(inputs_, resources_, machine_.programs, machine_.capabilities.maxStorageBlockBytes);
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
  while (!plan_.method->hasBudget() && plan_.method->stores() && totals.cursor > plan_.slots) {
    extraMs_ += timer_.totalMs();
    sizePool(grown(totals.cursor));
    list_.prepare(inputs_, resources_, machine_.programs,
                  machine_.capabilities.maxStorageBlockBytes);
    totals = runOnce();
    ++recaptures;
  }
  deepestSeen_ = std::max(deepestSeen_, totals.countMax);
  plan_.largestLayers = totals.kMax;
  lastCamera_ = camera;
  historyUsable_ = true;
  ++inputs_.frameIndex;
  FrameResult result = resultOf(totals);
  result.recaptures = recaptures;
  return result;
}

FrameResult FrameRenderer::resultOf(const shader::OitTotals& totals) const {
  FrameResult result;
  result.totalMs = timer_.totalMs() + extraMs_;
  result.passes = list_.times();
  const bool transparent = inputs_.facts.transparentTriangles > 0;
  result.lockFailures = totals.lockFailures;
  result.deepest = totals.countMax;
  if (!transparent) {
    result.fragments = FragmentCounts{};
    result.exact = true;
    return result;
  }
  if (!plan_.method->counts()) return result;
  FragmentCounts counts;
  counts.generated = totals.generated;
  counts.stored = totals.stored - std::min(totals.stored, totals.lockFailures);
  counts.lost = counts.generated - counts.stored;
  result.fragments = counts;
  if (totals.covered > 0) {
    result.layers = LayerStatistics{~totals.kMinInverted, totals.kMax,
                                    static_cast<double>(totals.cursor) / totals.covered};
  }
  // Where the device bounds loops, the sort of a deeper pixel would be cut short.
  const bool sorts = plan_.method->insertion == Insertion::Appended;
  const bool sortable = !sorts || machine_.capabilities.maxLoopIterations == 0 ||
                        totals.countMax <= kDeepestBoundedSort;
  result.exact =
      counts.lost == 0 && totals.cursor <= plan_.slots && plan_.sync != SyncMode::None && sortable;
  return result;
}

void FrameRenderer::readDisplay(std::vector<std::uint8_t>& rgb) const {
  readRgb(resources_.texture(Resource::DisplayColor), GL_UNSIGNED_BYTE, rgb);
}

void FrameRenderer::readLinear(std::vector<float>& rgb) const {
  readRgb(resources_.texture(Resource::LinearColor), GL_FLOAT, rgb);
}

}  // namespace macula::passes
