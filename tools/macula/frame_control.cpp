#include "frame_control.h"

namespace macula::tools {
namespace {

using control::QualityControl;

frame::QualityControls controlsOf(const control::ControlValues& values) {
  return {.resize = static_cast<float>(values[QualityControl::Resize]),
          .foveaSlope = static_cast<float>(values[QualityControl::FoveaSlope]),
          .layerShare = static_cast<float>(values[QualityControl::LayerShare])};
}

}  // namespace

std::string clockFaultOf(const gl::TimeSourceCheck& check) {
  const auto& ms = check.source == gl::TimeSource::Query ? check.queryMs : check.finishMs;
  static_assert(gl::TimeSourceCheck::kRepeats.front() == 1 &&
                gl::TimeSourceCheck::kRepeats.back() == 4);
  return control::clockFault(ms.front(), ms.back());
}

void FrameControl::steer(passes::FrameRenderer& renderer) {
  const control::ControlWork work{
      .resize = renderer.canResize(),
      .fovea = rendering_.foveation.enabled,
      .layers = passes::methodById(rendering_.oit.method).costFollowsBudget() &&
                renderer.inputs().facts.transparentTriangles > 0,
  };
  const control::ControlValues& values =
      controller_.next(times_ ? &*times_ : nullptr, usedResize_, work);
  times_.reset();
  renderer.setControls(controller_.active() ? controlsOf(values) : frame::QualityControls{});
}

void FrameControl::drawn(const passes::FrameRenderer& renderer) {
  const std::uint64_t frame = renderer.steps().frames - 1;
  usedResize_ = renderer.lod().resize;
  drawn_[frame % kDrawn] = {.renderer = frame, .controller = controller_.frame() - 1};
}

void FrameControl::note(const passes::FrameResult& result, std::optional<double> cpuMs,
                        std::optional<double> intervalMs) {
  const DrawnFrame& drawn = drawn_[result.frame % kDrawn];
  if (!result.timed || drawn.renderer != result.frame) return;
  times_ = control::FrameTimes{.frame = drawn.controller,
                               .resize = result.resizeFactor,
                               .totalMs = result.totalMs,
                               .resizableMs = result.resizableMs,
                               .cpuMs = cpuMs,
                               .intervalMs = intervalMs,
                               .overlapped = overlapped_};
}

void FrameControl::resized(glm::ivec2 size) {
  const double pixels = static_cast<double>(size.x) * static_cast<double>(size.y);
  if (pixels_ > 0.0 && pixels != pixels_) controller_.resized(pixels / pixels_);
  pixels_ = pixels;
}

void FrameControl::restart() {
  controller_.restart();
  times_.reset();
  usedResize_ = 1.0;
}

}  // namespace macula::tools
