// What a walk shows while programs are compiled: the opaque part of the scene, and a bar.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

#include "engine/scene/gpu_scene.h"
#include "passes/device_context.h"
#include "passes/frame_renderer.h"
#include "walk/frame_events.h"
#include "walk/screen.h"

namespace macula::tools {

class FirstImage {
 public:
  /// @param swap shows the back buffer of the window
  FirstImage(const Screen& screen, std::function<void()> swap)
      : screen_(screen), swap_(std::move(swap)) {}

  /// Draws the scene without what is transparent, whose programs take longest, and shows it. A
  /// scene without transparent surfaces, or one that the device refuses, is left to the frame.
  /// @return whether it is shown
  bool show(const passes::RenderSettings& settings, passes::DeviceContext& device,
            const scene::GpuScene& gpu, const FrameEvents& view);
  /// Shows a bar over it, or over nothing until it is there, now and then. @param done steps of
  /// total, see gl::ProgramCache::Progress
  void showProgress(std::size_t done, std::size_t total, glm::ivec2 window);

 private:
  using Clock = std::chrono::steady_clock;
  struct Opaque {
    passes::RenderSettings settings;
    passes::FrameRenderer renderer;
    Opaque(const passes::RenderSettings& s, passes::DeviceContext& device)
        : settings(s), renderer(settings, device) {}
  };

  const Screen& screen_;
  std::function<void()> swap_;
  std::unique_ptr<Opaque> opaque_;  ///< once it is drawn
  std::optional<Clock::time_point> shown_;
};

}  // namespace macula::tools
