// Reads the inputs of a network of importance back from a drawn frame, for training.
#pragma once

#include <vector>

#include "passes/frame_renderer.h"

namespace macula::passes {

/// The features of every sample of the last frame, by the shader that evaluates the network.
/// @param renderer drew with a method that uses a network, transparency at full rate, and with
///   RenderSettings::readBack where the network is Macula's own
/// @param opaque drew the same view of the same scene at the same size, showTransparency(false):
///   a finished frame no longer holds the opaque image that the network read
/// @returns width x height x features, rows from the top; 0 where nothing is transparent
/// @throws std::invalid_argument where they did not
[[nodiscard]] std::vector<float> readFeatures(FrameRenderer& renderer, const FrameRenderer& opaque,
                                              gl::ProgramCache& programs);

/// Evaluates a network for given features by that shader, for the check against the program that
/// trained it.
/// @param features inputs one after another: a multiple of the network's features
/// @returns as many times its outputs, unbounded as the last layer computes them
[[nodiscard]] std::vector<float> evaluateOnGpu(const network::Network& network, NetworkModel model,
                                               const std::vector<float>& features,
                                               gl::ProgramCache& programs);

}  // namespace macula::passes
