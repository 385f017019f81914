// The layers of a network from the tensors of its file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/network/network.h"
#include "engine/network/safetensors.h"

namespace macula::network {

/// Layers from `layer0.weight`, `layer0.bias`, `layer1.weight`, ...
/// @param inputs, outputs of the whole network @param name of the file in messages
/// @throws InputError naming file, tensor and mend
[[nodiscard]] std::vector<DenseLayer> layersOf(const std::map<std::string, Tensor>& tensors,
                                               std::size_t inputs, std::size_t outputs,
                                               const std::string& name);

}  // namespace macula::network
