// Any bytes as a network: one whose counts agree and that evaluates, or one InputError.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "engine/core/error.h"
#include "engine/network/network.h"

namespace {

using namespace macula::network;

void require(bool holds) {
  if (!holds) std::abort();
}

bool finite(const std::vector<float>& values) {
  for (const float value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

void check(const Network& network) {
  const std::size_t inputs = network.features.size();
  require(inputs > 0 && inputs <= kMaxInputs && network.layers.size() <= kMaxLayers);
  require(network.mean.size() == inputs && network.scale.size() == inputs);
  require(finite(network.mean) && finite(network.scale));
  std::size_t values = inputs;
  for (const DenseLayer& layer : network.layers) {
    require(static_cast<std::size_t>(layer.inputs) == values);
    values = static_cast<std::size_t>(layer.outputs);
    require(values > 0 && values <= kMaxWidth && layer.bias.size() == values);
    require(layer.weights.size() == values * static_cast<std::size_t>(layer.inputs));
    require(finite(layer.weights) && finite(layer.bias));
  }
  require(values == network.outputs.size());
  require(evaluate(network, std::vector<float>(inputs, 0.5F)).size() == values);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    check(parseNetwork(std::as_bytes(std::span(data, size)), "fuzz"));
  } catch (const macula::InputError&) {
    // The expected answer to most inputs.
  }
  return 0;
}
