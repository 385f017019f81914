// The present view drawn once more, by other settings, away from the window.
#pragma once

#include "engine/image/image.h"
#include "passes/device_context.h"
#include "passes/frame_renderer.h"
#include "walk/frame_events.h"

namespace macula::tools {

/// The heat map and the tone curve's output may differ from what the window shows; the methods'
/// own settings count as given.
/// @param controls as the window has them, or at rest
/// @throws InputError where the settings or the memory do not allow it
[[nodiscard]] image::Image8 drawStill(const passes::RenderSettings& settings,
                                      passes::DeviceContext& device, const scene::GpuScene& gpu,
                                      const FrameEvents& view,
                                      const frame::QualityControls& controls);

/// The same with linear values after the tone curve.
[[nodiscard]] image::ImageF drawLinearStill(const passes::RenderSettings& settings,
                                            passes::DeviceContext& device,
                                            const scene::GpuScene& gpu, const FrameEvents& view,
                                            const frame::QualityControls& controls);

}  // namespace macula::tools
