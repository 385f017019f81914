#include "walk/first_image.h"

#include <algorithm>

#include "engine/core/error.h"

namespace macula::tools {
namespace {

constexpr glm::vec3 kBehind{0.05F, 0.055F, 0.07F};
constexpr glm::vec3 kBar{0.35F, 0.6F, 0.9F};
constexpr glm::vec3 kTrack{0.13F, 0.19F, 0.29F};  ///< of the bar; seen over a scene and over none
/// Between two pictures of the bar: often enough to be seen moving, seldom enough to cost little.
constexpr auto kPause = std::chrono::milliseconds(100);

}  // namespace

bool FirstImage::show(const passes::RenderSettings& settings, passes::DeviceContext& device,
                      const scene::GpuScene& gpu, const FrameEvents& view) {
  if (gpu.facts().transparentTriangles == 0) return false;
  passes::RenderSettings plain = settings;
  plain.heatmap.map = "none";
  auto opaque = std::make_unique<Opaque>(plain, device);
  try {
    passes::FrameRenderer& renderer = opaque->renderer;
    renderer.showTransparency(false);
    renderer.resize(view.pictureSize);
    renderer.setScene(gpu);
    (void)renderer.render(view.camera, view.gaze);  // with a bar over no image, see showProgress()
    screen_.clear(glm::vec3(0.0F));
    screen_.show(renderer.shownTexture());
    swap_();
    opaque_ = std::move(opaque);
    return true;
  } catch (const InputError&) {
    return false;  // the frame itself says what is wrong
  }
}

void FirstImage::showProgress(std::size_t done, std::size_t total, glm::ivec2 window) {
  const Clock::time_point now = Clock::now();
  if (done == 1) shown_ = now;  // a batch that is ready at once shows nothing
  if (done == total || !shown_ || now - *shown_ < kPause) return;
  shown_ = now;
  screen_.clear(kBehind);
  if (opaque_) screen_.show(opaque_->renderer.shownTexture());
  constexpr int kParts = 4;        // of the window's width is the bar
  constexpr int kHeightPart = 60;  // of its height
  const glm::ivec2 size(window.x / kParts * 2, std::max(2, window.y / kHeightPart));
  const glm::ivec2 low((window.x - size.x) / 2, 3 * size.y);
  const auto filled = static_cast<int>(static_cast<std::size_t>(size.x) * done / total);
  screen_.fill({low, size}, kTrack);
  screen_.fill({low, {filled, size.y}}, kBar);
  swap_();
}

}  // namespace macula::tools
