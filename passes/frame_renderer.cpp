#include "passes/frame_renderer.h"

#include <algorithm>

#include "engine/core/error.h"
#include "engine/core/plural.h"
#include "passes/device_fit.h"
#include "passes/frame_list.h"
#include "passes/oit/slots.h"

namespace macula::passes {

FrameRenderer::FrameRenderer(const RenderSettings& settings, DeviceContext& device)
    : settings_(settings),
      device_(device),
      plan_{.method = &methodById(settings.oit.method)},
      list_(makeFrameList(settings, plan_, lod_)),
      numbers_(device.time.source) {
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
  const gl::Limits& limits = device_.capabilities.limits;
  const std::int64_t most =
      std::min({limits[gl::Limit::TextureSide], limits[gl::Limit::FramebufferWidth],
                limits[gl::Limit::FramebufferHeight]});
  if (side > most) {
    failInput(
        "{}x{} with {} per axis is more than this GPU's {} texels a side; lower "
        "--size or --ssaa",
        outputSize.x, outputSize.y,
        counted(static_cast<std::uint64_t>(settings_.tonemap.ssaa), "sample"), most);
  }
  inputs_.outputSize = outputSize;
  settingsChanged();
}

void FrameRenderer::settingsChanged() {
  prepared_ = false;
  history_.usable = false;
  forgetNumbers();
  ++steps_.resets;
}

void FrameRenderer::setControls(const frame::QualityControls& controls) {
  inputs_.controls = controls;
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
  history_ = {};
  plan_ = {.method = &methodById(settings_.oit.method)};
  list_ = makeFrameList(settings_, plan_, lod_);
  resources_ = {};
  inputs_.frameIndex = 0;
  deepestSeen_ = 0;
  mayReduce_ = false;
  prepared_ = false;
  unfinished_ = false;
  forgetNumbers();
  ++steps_.restarts;
}

void FrameRenderer::forgetNumbers() {
  numbers_.drop();
  lastSlot_ = FrameNumbers::kNoSlot;
  askedSlots_ = 0;
}

void FrameRenderer::enlargePool(std::uint32_t asked) {
  growPool(plan_, asked);
  allocate();
}

void FrameRenderer::prepareForReducedRate() {
  if (mayReduce_ || inputs_.controls.resize <= 1.0F) return;
  // Only the passes are prepared again; nothing that a frame remembers depends on it.
  mayReduce_ = true;
  const bool ready =
      lod_.wanted == lod_.canResizeShading && lod_.transparency == lod_.canResizeTransparency;
  if (!ready) prepared_ = false;
}

void FrameRenderer::allocate() {
  try {
    list_.prepare(inputs_, resources_, device_.programs,
                  {.limits = device_.capabilities.limits, .shareMemory = !settings_.readBack});
  } catch (...) {
    // No frame may be drawn with a pool that is larger than its memory: the next one plans again.
    prepared_ = false;
    plan_.slots = 0;
    throw;
  }
}

void FrameRenderer::prepare() {
  forgetNumbers();  // those on their way are of other passes
  inputs_.displaySize = inputs_.outputSize * settings_.tonemap.ssaa;
  const auto samples = static_cast<std::uint64_t>(inputs_.displaySize.x) *
                       static_cast<std::uint64_t>(inputs_.displaySize.y);
  checkCombination(settings_.oit);
  plan_.importance = settings_.importance;
  plan_.seed = settings_.seed;
  plan_.factorMaps = needsFactors(settings_.heatmap.map);
  planMethod(plan_, {.settings = settings_.oit,
                     .device = device_.capabilities,
                     .ordered = device_.ordered,
                     .samples = samples});
  planNetwork(plan_, network_);
  planLod(lod_, settings_.lod, settings_.foveation, inputs_.facts, mayReduce_);
  plan_.resizable = lod_.transparency;
  plan_.imageSize = inputs_.displaySize;
  resources_.setBackground(settings_.background);
  checkDevice(list_, {settings_, inputs_, device_});
  allocate();
  prepared_ = true;
}

}  // namespace macula::passes
