// What a network of importance sees of a drawn frame, brought back from the GPU for training.
#pragma once

#include <vector>

#include "passes/frame_renderer.h"

namespace macula::passes {

/// The features of every sample of the last frame, by the shader that evaluates the network.
/// @param renderer drew with a method that uses a network, transparency at full rate
/// @param opaque drew the same view of the same scene at the same size, showTransparency(false):
///   a drawn frame no longer holds the opaque image that the network saw behind its fragments
/// @returns width x height x features, rows from the top; 0 where nothing is transparent
/// @throws std::invalid_argument where they did not
[[nodiscard]] std::vector<float> readFeatures(FrameRenderer& renderer, const FrameRenderer& opaque,
                                              gl::ProgramCache& programs);

/// What the network says of given features, by that shader. For the check against the program that
/// trained it.
/// @param features inputs one after another: a multiple of the network's features
/// @returns as many times its outputs, before they are made layers
[[nodiscard]] std::vector<float> evaluateOnGpu(const network::Network& network, NetworkModel model,
                                               const std::vector<float>& features,
                                               gl::ProgramCache& programs);

}  // namespace macula::passes
