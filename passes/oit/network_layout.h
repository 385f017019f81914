// A network of importance as the shaders take it: checked against what they compute, and written
// out.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gl/shader_source.h"
#include "engine/network/network.h"

namespace macula::passes {

/// Which features a network sees and what it says.
enum class NetworkModel {
  Thesis,   ///< Tsopouridis 2021, chapter 4: twelve features, importance in 0..1
  Learned,  ///< Macula's own: depth slices, corrections of the error that they predict
};

/// What "model" says in a file of this kind.
[[nodiscard]] std::string_view nameOf(NetworkModel model);
/// Names of the features in the order of shaders/lib/thesis_features.glsl or learned_features.glsl.
[[nodiscard]] std::vector<std::string> featuresOf(NetworkModel model);
[[nodiscard]] std::vector<std::string> outputsOf(NetworkModel model);

/// The weights that come with Macula.
[[nodiscard]] std::filesystem::path defaultNetworkFile(NetworkModel model);

/// Reads a network of a model.
/// @throws InputError naming the file where it is none, is of another model, sees other features,
///         says something else, or has more weights than a shader should hold: a driver's compiler
///         takes seconds for twice those of the thesis
[[nodiscard]] network::Network readNetworkOf(NetworkModel model, const std::filesystem::path& file);

/// The network as defines of shaders/oit/network.comp. @param sliceTile samples a side that share
/// depth slices
[[nodiscard]] gl::Defines networkDefines(const network::Network& network, NetworkModel model,
                                         int sliceTile);

}  // namespace macula::passes
