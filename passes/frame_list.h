// The frame in order.
#pragma once

#include "engine/frame/frame_list.h"
#include "passes/lod/plan.h"
#include "passes/oit/plan.h"
#include "passes/render_settings.h"

namespace macula::passes {

/// Makes the list of all passes. No GL. Settings and plans must outlive it.
[[nodiscard]] frame::FrameList makeFrameList(const RenderSettings& settings, const OitPlan& plan,
                                             const LodPlan& lod);

/// Inputs that answer which passes a scene runs, without a GPU.
[[nodiscard]] frame::FrameInputs inputsOf(const scene::SceneFacts& facts);

}  // namespace macula::passes
