// FrameRenderer: one frame.
#include <algorithm>

#include "engine/scene/camera_path.h"
#include "engine/scene/view.h"
#include "passes/frame_renderer.h"
#include "passes/oit/slots.h"

namespace macula::passes {
namespace {

/// N_limit before anything was counted: the paper's own range is 20 to 30 (Vasilakis 2017, 3.2).
constexpr float kFirstLayerLimit = 30.0F;

}  // namespace

frame::PassContext FrameRenderer::passContext() {
  return {inputs_, resources_, list_.barriers(), constants_.ids()};
}

void FrameRenderer::beginFrame(const scene::Camera& camera, const gaze::PointOfInterest& gaze,
                               bool cut) {
  if (unfinished_) restart();
  unfinished_ = true;
  prepareForReducedRate();
  if (!prepared_) prepare();
  const glm::vec2 size(inputs_.displaySize);
  inputs_.view = scene::makeView(camera, size.x / size.y);
  inputs_.gpu->chooseLights(camera, size.x / size.y);
  inputs_.gpu->chooseVisible(inputs_.view.viewProjection);
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

void FrameRenderer::run(gl::FrameTimer* timer) {
  constants_.upload({inputs_, plan_, lod_, settings_.background, history_.viewProjection});
  frame::PassContext context = passContext();
  context.bindConstants(frame::Raster::Image);
  inputs_.gpu->bindLights();  // at bindings that no pass uses otherwise
  list_.run(context, timer);
}

void FrameRenderer::sumUp(IssuedFrame& frame) {
  frame::PassContext context = passContext();
  list_.runReport(context);
  frame.statistics = true;
}

/// Runs the frame and sends its numbers on their way.
void FrameRenderer::runInto(std::size_t slot) {
  IssuedFrame& frame = numbers_.frame(slot);
  describe(frame);
  if (frame.timed) numbers_.timer().begin(slot);
  run(frame.timed ? &numbers_.timer() : nullptr);
  // After the last mark: its time is not the frame's.
  if (statisticsWanted()) sumUp(frame);
  numbers_.copy(slot, resources_);
}

FrameResult FrameRenderer::render(const scene::Camera& camera, const gaze::PointOfInterest& gaze,
                                  bool cut) {
  forgetNumbers();
  beginFrame(camera, gaze, cut);
  const std::size_t slot = lastSlot_ = numbers_.take();
  double givenUpMs = 0.0;
  int recaptures = 0;
  for (;;) {
    runInto(slot);
    numbers_.wait(slot);
    const std::uint32_t asked = numbers_.sums(slot).totals.cursor;
    if (!needsLargerPool(plan_, asked)) break;
    if (numbers_.frame(slot).timed) givenUpMs += numbers_.timer().totalMs(slot);
    enlargePool(asked);
    ++recaptures;
  }
  FrameResult result = resultOf(slot);
  numbers_.free(slot);
  result.totalMs += givenUpMs;
  result.recaptures = recaptures;
  leaveHistory(camera);
  unfinished_ = false;
  return result;
}

void FrameRenderer::draw(const scene::Camera& camera, const gaze::PointOfInterest& gaze, bool cut) {
  if (prepared_ && !unfinished_ && needsLargerPool(plan_, askedSlots_)) {
    const std::uint32_t asked = askedSlots_;
    forgetNumbers();  // those on their way are of the small pool as well
    enlargePool(asked);
  }
  beginFrame(camera, gaze, cut);
  lastSlot_ = numbers_.take();
  if (lastSlot_ == FrameNumbers::kNoSlot) {
    run(nullptr);
  } else {
    runInto(lastSlot_);
  }
  leaveHistory(camera);
  unfinished_ = false;
}

void FrameRenderer::leaveHistory(const scene::Camera& camera) {
  history_ = {.camera = camera,
              .viewProjection = inputs_.view.viewProjection,
              .transparencySize = plan_.size,
              .usable = true};
  ++inputs_.frameIndex;
  ++steps_.frames;
}

}  // namespace macula::passes
