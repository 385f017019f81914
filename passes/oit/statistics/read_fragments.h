// Every fragment of a drawn frame, read back from the GPU for the oracles.
#pragma once

#include "engine/measure/fragment_image.h"
#include "passes/frame_renderer.h"

namespace macula::passes {

/// The fragments of the last frame of `exact`, sorted by (depth, id) as the resolve pass sorts
/// them, over the opaque image of `opaque`. One pixel of the result is one sample, so that
/// supersampled frames come back at their full size.
/// @param exact drew with ab-sbuffer, and its last frame was exact
/// @param opaque drew the same view of the same scene at the same size, showTransparency(false)
/// @throws std::invalid_argument where they did not
[[nodiscard]] measure::FragmentImage readFragments(const FrameRenderer& exact,
                                                   const FrameRenderer& opaque);

}  // namespace macula::passes
