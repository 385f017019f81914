#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/network/network.h"

namespace macula::network {
namespace {

std::vector<float> sums(const DenseLayer& layer, std::span<const float> inputs) {
  std::vector<float> values = layer.bias;
  for (std::size_t row = 0; row < values.size(); ++row) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      values[row] += layer.weights[row * inputs.size() + i] * inputs[i];
    }
  }
  return values;
}

}  // namespace

std::vector<float> evaluate(const Network& network, std::span<const float> features) {
  if (features.size() != network.features.size()) {
    throw std::invalid_argument("evaluate: the number of features is not the network's");
  }
  std::vector<float> values(features.begin(), features.end());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = (values[i] - network.mean[i]) * network.scale[i];
  }
  for (std::size_t i = 0; i < network.layers.size(); ++i) {
    if (i > 0) {
      for (float& value : values) value = std::max(value, 0.0F);
    }
    values = sums(network.layers[i], values);
  }
  if (network.outputActivation == OutputActivation::Sigmoid) {
    for (float& value : values) value = 1.0F / (1.0F + std::exp(-value));
  }
  return values;
}

}  // namespace macula::network
