// The parts of a network from the texts and the tensors of its file.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "engine/network/network.h"
#include "engine/network/safetensors.h"

namespace macula::network {

/// A network without layers: names, normalisation and where it came from.
/// @param name of the file in messages
/// @throws InputError naming file, key and fix
[[nodiscard]] Network parseMetadata(const nlohmann::json& metadata, const std::string& name);

/// Layers from `layer0.weight`, `layer0.bias`, `layer1.weight`, ...
/// @param inputs, outputs of the whole network @param name of the file in messages
/// @throws InputError naming file, tensor and fix
[[nodiscard]] std::vector<DenseLayer> layersOf(const std::map<std::string, Tensor>& tensors,
                                               std::size_t inputs, std::size_t outputs,
                                               const std::string& name);

}  // namespace macula::network
