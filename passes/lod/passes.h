// Every pass of the level of detail; passes/frame_list.cpp names their order.
#pragma once

#include <memory>

#include "engine/frame/pass.h"
#include "passes/lod/plan.h"

namespace macula::passes {

using LodPassPtr = std::unique_ptr<frame::Pass>;

// Opaque surfaces: which samples to shade, the samples, pixels from them, pixels that none fits.
[[nodiscard]] LodPassPtr makeLodRatesPass(const LodPlan& plan);
[[nodiscard]] LodPassPtr makeLodShadePass(const LodPlan& plan);
[[nodiscard]] LodPassPtr makeLodReconstructPass(const LodPlan& plan);
[[nodiscard]] LodPassPtr makeLodHolesPass(const LodPlan& plan);

// Transparent surfaces: what the passes of transparency draw over at a reduced rate, and the result
// over the image.
[[nodiscard]] LodPassPtr makeLodDepthPass(const LodPlan& plan);
[[nodiscard]] LodPassPtr makeLodTransparencyPass(const LodPlan& plan);

}  // namespace macula::passes
