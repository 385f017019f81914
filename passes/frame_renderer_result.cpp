// FrameRenderer: what is told about a frame, at once or later.
#include <algorithm>
#include <stdexcept>

#include "passes/frame_renderer.h"
#include "passes/oit/slots.h"

namespace macula::passes {
namespace {

// Passes whose work follows 1 / r^2.
constexpr std::string_view kShadePass = "lod.shade";
constexpr std::string_view kTransparencyPasses = "oit.";
/// Shades at full rate, until anything asks for less.
constexpr std::string_view kLightingPass = "lighting";

std::uint64_t samplesOf(glm::ivec2 size) {
  return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
}

}  // namespace

void FrameRenderer::describe(IssuedFrame& frame) const {
  frame.number = steps_.frames;
  frame.plan = plan_;
  frame.resizeFactor = lod_.resize;
  const std::uint64_t pixels = samplesOf(inputs_.displaySize);
  frame.shading = {
      .pixels = pixels, .shaded = lod_.wanted ? samplesOf(lod_.texels) : pixels, .holes = 0};
  frame.countsHoles = lod_.wanted && !lod_.fullRate();
  frame.countsShaded = frame.countsHoles && lod_.foveated;
  frame.transparent = inputs_.facts.transparentTriangles > 0;
  frame.timed = wanted_.times && settings_.timing;
  frame.statistics = false;
  frame.told = false;
}

bool FrameRenderer::statisticsWanted() const {
  if (inputs_.facts.transparentTriangles == 0 || !plan_.method->insertion.counted) return false;
  const bool shown = resources_.has(kHeatmapColor) && rangeFollowsFrames(settings_.heatmap);
  return wanted_.statistics || shown;
}

std::optional<FrameResult> FrameRenderer::takeResult() {
  std::optional<FrameResult> newest;
  for (;;) {
    const std::size_t slot = numbers_.ready();
    if (slot == FrameNumbers::kNoSlot) return newest;
    newest = resultOf(slot);
    numbers_.free(slot);
  }
}

FrameResult FrameRenderer::waitForResult() {
  if (history_.camera == std::nullopt || !history_.usable) {
    throw std::logic_error("there is no frame to wait for");
  }
  if (lastSlot_ == FrameNumbers::kNoSlot) {
    numbers_.drop();
    lastSlot_ = numbers_.take();
    describe(numbers_.frame(lastSlot_));
    numbers_.frame(lastSlot_).number = steps_.frames - 1;
    numbers_.frame(lastSlot_).timed = false;  // it was drawn without marks
  }
  IssuedFrame& frame = numbers_.frame(lastSlot_);
  const bool counts = frame.transparent && plan_.method->insertion.counted;
  if (counts && !frame.statistics) sumUp(frame);
  numbers_.copy(lastSlot_, resources_);
  numbers_.wait(lastSlot_);
  const FrameResult result = resultOf(lastSlot_);
  numbers_.drop();  // the earlier ones are of no interest now
  return result;
}

FrameResult FrameRenderer::resultOf(std::size_t slot) {
  IssuedFrame& frame = numbers_.frame(slot);
  const FrameSums sums = numbers_.sums(slot);
  noteOverflow(frame, sums.totals.cursor);
  frame.told = true;
  FrameResult result;
  result.frame = frame.number;
  result.resizeFactor = frame.resizeFactor;
  result.shading = frame.shading;
  if (frame.countsShaded) result.shading.shaded = sums.lod.shaded;
  if (frame.countsHoles) {
    result.shading.holes = sums.lod.dispatches[LOD_RATES].w;
    result.shading.shaded += result.shading.holes;
  }
  result.lockFailures = sums.totals.lockFailures;
  result.overflows = overflows_;
  setTimes(result, slot);
  setFragments(result, frame, sums);
  return result;
}

void FrameRenderer::setTimes(FrameResult& result, std::size_t slot) {
  passTimes_.clear();
  result.timed = numbers_.frame(slot).timed;
  if (!result.timed) return;
  const gl::FrameTimer& timer = numbers_.timer();
  result.totalMs = timer.totalMs(slot);
  // The passes have been the same since the frame was drawn: what changes them forgets the numbers
  // that are on their way.
  for (std::size_t i = 0; i < timer.intervals(slot); ++i) {
    passTimes_.push_back({list_.ran()[i], timer.intervalMs(slot, i)});
    if (isResizable(passTimes_.back().name)) result.resizableMs += passTimes_.back().ms;
  }
  result.passes = passTimes_;
}

bool FrameRenderer::isResizable(std::string_view pass) const {
  if (lod_.canResizeTransparency && pass.starts_with(kTransparencyPasses)) return true;
  return lod_.canResizeShading && pass == (lod_.wanted ? kShadePass : kLightingPass);
}

/// Of a frame that was left as it is, although its pool was too small.
void FrameRenderer::noteOverflow(IssuedFrame& frame, std::uint32_t asked) {
  if (frame.told || !needsLargerPool(frame.plan, asked)) return;
  askedSlots_ = std::max(askedSlots_, asked);
  ++overflows_;
}

void FrameRenderer::setFragments(FrameResult& result, const IssuedFrame& frame,
                                 const FrameSums& sums) {
  if (!frame.transparent) {
    result.counted = true;
    result.fragments = FragmentCounts{};
    result.exact = true;
    return;
  }
  if (!frame.plan.method->insertion.counted) {
    result.counted = true;
    return;
  }
  if (!frame.statistics) {
    deepestSeen_ = std::max(deepestSeen_, sums.totals.countMax);
    return;
  }
  const FragmentReport report =
      reportOf(frame.plan, sums.statistics, sums.totals, device_.capabilities);
  deepestSeen_ = std::max(deepestSeen_, report.deepest);
  plan_.largestLayers = report.largestLayers;
  result.counted = true;
  result.fragments = report.fragments;
  result.layers = report.layers;
  result.deepest = report.deepest;
  result.tailSlots = report.tailSlots;
  result.exact = report.exact;
}

}  // namespace macula::passes
