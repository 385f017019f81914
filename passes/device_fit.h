// Whether a device can run the passes of a frame, asked before anything is made.
#pragma once

#include "engine/frame/frame_list.h"
#include "passes/device_context.h"
#include "passes/render_settings.h"

namespace macula::passes {

/// What a frame is planned from.
struct FitInputs {
  const RenderSettings& settings;
  const frame::FrameInputs& frame;
  const DeviceContext& device;
};

/// @throws InputError where a pass of the list, or the scene, needs more than the device offers:
/// names pass, limit, both numbers and the methods that would run
void checkDevice(const frame::FrameList& list, const FitInputs& in);

}  // namespace macula::passes
