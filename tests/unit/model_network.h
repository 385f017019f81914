// Networks of importance made up from random numbers, and their files: tests do not lean on the
// weights that ship.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "network_builder.h"
#include "passes/oit/learned/network_layout.h"

namespace macula::test {

/// A network that fits a model: means in -1 .. 1, scales in 0.5 .. 1.5, weights so large that sums
/// stay about as large as the inputs.
/// @param hidden values of each hidden layer
inline network::Network randomNetwork(passes::NetworkModel model, const std::vector<int>& hidden,
                                      std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto between = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(random() >> 8U) / 16777216.0F;
  };
  network::Network made;
  made.model = passes::nameOf(model);
  made.features = passes::featuresOf(model);
  made.outputs = passes::outputsOf(model);
  for (std::size_t i = 0; i < made.features.size(); ++i) {
    made.mean.push_back(between(-1.0F, 1.0F));
    made.scale.push_back(between(0.5F, 1.5F));
  }
  made.outputActivation = model == passes::NetworkModel::Thesis ? network::OutputActivation::Sigmoid
                                                                : network::OutputActivation::None;
  std::vector<int> sizes{static_cast<int>(made.features.size())};
  sizes.insert(sizes.end(), hidden.begin(), hidden.end());
  sizes.push_back(static_cast<int>(made.outputs.size()));
  for (std::size_t l = 0; l + 1 < sizes.size(); ++l) {
    network::DenseLayer layer{
        .inputs = sizes[l], .outputs = sizes[l + 1], .weights = {}, .bias = {}};
    const float most = std::sqrt(3.0F / static_cast<float>(layer.inputs));
    for (int i = 0; i < layer.inputs * layer.outputs; ++i) {
      layer.weights.push_back(between(-most, most));
    }
    for (int i = 0; i < layer.outputs; ++i) layer.bias.push_back(between(-0.5F, 0.5F));
    made.layers.push_back(std::move(layer));
  }
  made.command = "none";
  made.dataHash = std::string(64, '0');
  return made;
}

/// The bytes of a network's file, in 32-bit floats.
inline std::string fileOf(const network::Network& network) {
  const auto joined = [](const auto& values, const char* format, char separator) {
    std::string text;
    for (const auto& value : values) {
      if (!text.empty()) text += separator;
      text += fmt::format(fmt::runtime(format), value);
    }
    return text;
  };
  network::test::NetworkFile file;
  file.header["__metadata__"] = network::test::metadataOf(
      joined(network.features, "{}", ','), joined(network.outputs, "{}", ','),
      joined(network.mean, "{:.9g}", ' '), joined(network.scale, "{:.9g}", ' '));
  file.header["__metadata__"]["model"] = network.model;
  file.header["__metadata__"]["output_activation"] =
      network.outputActivation == network::OutputActivation::Sigmoid ? "sigmoid" : "none";
  for (std::size_t l = 0; l < network.layers.size(); ++l) {
    const network::DenseLayer& layer = network.layers[l];
    const auto inputs = static_cast<std::size_t>(layer.inputs);
    const auto outputs = static_cast<std::size_t>(layer.outputs);
    file.addF32(fmt::format("layer{}.weight", l), {outputs, inputs}, layer.weights);
    file.addF32(fmt::format("layer{}.bias", l), {outputs}, layer.bias);
  }
  return file.bytes();
}

}  // namespace macula::test
