// A network of importance as the shaders expect it: its inputs and outputs checked by name, and its
// arithmetic written as shader text.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gl/shader_source.h"
#include "engine/network/network.h"

namespace macula::passes {

/// Inputs and outputs of a network.
enum class NetworkModel {
  Thesis,   ///< Tsopouridis 2021, chapter 4: twelve features, importance in 0..1
  Learned,  ///< Macula's own: depth slices, corrections of the error that they predict
};

/// The value of "model" in a file of this kind.
[[nodiscard]] std::string_view nameOf(NetworkModel model);
/// Names of the features in the order of shaders/lib/thesis_features.glsl or learned_features.glsl.
[[nodiscard]] std::vector<std::string> featuresOf(NetworkModel model);
[[nodiscard]] std::vector<std::string> outputsOf(NetworkModel model);

/// The weights that come with Macula.
[[nodiscard]] std::filesystem::path defaultNetworkFile(NetworkModel model);

/// Reads a network of a model.
/// @throws InputError naming the file where it is no network, is of another model, has other inputs
/// or
///         outputs, or has more weights than a shader should hold: a driver's compiler takes
///         seconds for twice those of the thesis
[[nodiscard]] network::Network readNetworkOf(NetworkModel model, const std::filesystem::path& file);

/// The network of a plan, read again where another one is asked for.
class LoadedNetwork {
 public:
  /// @param chosen empty: the weights that come with Macula · @throws InputError, see
  /// readNetworkOf()
  [[nodiscard]] const network::Network& get(NetworkModel model,
                                            const std::filesystem::path& chosen);

 private:
  std::optional<network::Network> network_;
  std::filesystem::path file_;
};

/// The network as defines of shaders/oit/network.comp. @param sliceTile samples a side that share
/// depth slices
[[nodiscard]] gl::Defines networkDefines(const network::Network& network, NetworkModel model,
                                         int sliceTile);

}  // namespace macula::passes
