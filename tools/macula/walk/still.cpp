#include "walk/still.h"

namespace macula::tools {
namespace {

/// Frames until history says what it says in a view that stands still.
constexpr int kSettlingFrames = 2;

void drawSettled(passes::FrameRenderer& renderer, const scene::GpuScene& gpu,
                 const FrameEvents& view, const frame::QualityControls& controls) {
  renderer.resize(view.pictureSize);
  renderer.setScene(gpu);
  renderer.setControls(controls);
  renderer.want({.times = false, .statistics = false});
  for (int i = 0; i < kSettlingFrames; ++i) renderer.render(view.camera, view.gaze);
}

}  // namespace

image::Image8 drawStill(const passes::RenderSettings& settings, passes::DeviceContext& device,
                        const scene::GpuScene& gpu, const FrameEvents& view,
                        const frame::QualityControls& controls) {
  passes::RenderSettings own = settings;
  own.heatmap.map = "none";
  passes::FrameRenderer renderer(own, device);
  drawSettled(renderer, gpu, view, controls);
  image::Image8 image{view.pictureSize.x, view.pictureSize.y, 3, {}};
  renderer.readDisplay(image.pixels);
  return image;
}

image::ImageF drawLinearStill(const passes::RenderSettings& settings, passes::DeviceContext& device,
                              const scene::GpuScene& gpu, const FrameEvents& view,
                              const frame::QualityControls& controls) {
  passes::RenderSettings own = settings;
  own.heatmap.map = "none";
  own.tonemap.linearOut = true;
  passes::FrameRenderer renderer(own, device);
  drawSettled(renderer, gpu, view, controls);
  image::ImageF image{view.pictureSize.x, view.pictureSize.y, 3, {}, true};
  renderer.readLinear(image.pixels);
  return image;
}

}  // namespace macula::tools
