// Control of a renderer's frame time: the controller, with what it needs to know of the renderer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "engine/control/controller.h"
#include "engine/gl/time_source.h"
#include "passes/frame_renderer.h"

namespace macula::tools {

/// Why the clock that frames are timed by cannot be controlled by; empty where it can.
[[nodiscard]] std::string clockFaultOf(const gl::TimeSourceCheck& check);

/// Sets the quality controls of one renderer, frame by frame.
class FrameControl {
 public:
  /// @param settings, rendering must outlive it; may change at any time
  FrameControl(const control::ControlSettings& settings, const passes::RenderSettings& rendering,
               const gl::TimeSourceCheck& check)
      : controller_(settings, clockFaultOf(check)),
        settings_(settings),
        rendering_(rendering),
        overlapped_(check.source == gl::TimeSource::Query) {}

  /// Sets those of the next frame; at rest where nothing is controlled.
  void steer(passes::FrameRenderer& renderer);
  /// That frame was drawn.
  void drawn(const passes::FrameRenderer& renderer);
  /// Takes the times of a frame, at once or some frames later; nothing where it was not timed.
  /// @param cpuMs, intervalMs as control::FrameTimes has them
  void note(const passes::FrameResult& result, std::optional<double> cpuMs = {},
            std::optional<double> intervalMs = {});
  /// The next frames have so many pixels.
  void resized(glm::ivec2 size);
  /// The next frames are of another scene.
  void restart();

  [[nodiscard]] const control::ControlSettings& settings() const { return settings_; }
  [[nodiscard]] const control::Controller& controller() const { return controller_; }

 private:
  control::Controller controller_;
  const control::ControlSettings& settings_;
  const passes::RenderSettings& rendering_;
  /// A frame by the renderer's count and by the controller's.
  struct DrawnFrame {
    std::uint64_t renderer = ~std::uint64_t{0};
    std::uint64_t controller = 0;
  };
  static constexpr std::size_t kDrawn = 16;  ///< more than any GPU is behind by

  const bool overlapped_;
  std::array<DrawnFrame, kDrawn> drawn_;      ///< the last ones, by the renderer's count
  std::optional<control::FrameTimes> times_;  ///< the newest
  double usedResize_ = 1.0;
  double pixels_ = 0.0;  ///< of the image; 0: not known yet
};

}  // namespace macula::tools
