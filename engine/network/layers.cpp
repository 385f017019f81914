#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/plural.h"
#include "engine/network/parts.h"
#include "engine/settings/data_node.h"

namespace macula::network {
namespace {

using Tensors = std::map<std::string, Tensor>;

std::string weightName(std::size_t layer) {
  return fmt::format("layer{}.weight", layer);
}

std::string biasName(std::size_t layer) {
  return fmt::format("layer{}.bias", layer);
}

const Tensor& tensorNamed(const Tensors& tensors, const std::string& key, std::size_t dimensions,
                          const std::string& name) {
  const auto found = tensors.find(key);
  if (found == tensors.end()) {
    failInput("{}: tensor '{}' is missing; {} with it", name, key, kExportAgain);
  }
  if (found->second.shape.size() != dimensions) {
    failInput("{}: tensor '{}': has {}, not {}; {}", name, key,
              counted(found->second.shape.size(), "dimension"), dimensions, kExportAgain);
  }
  return found->second;
}

std::vector<float> finiteValues(const Tensor& tensor, const std::string& key,
                                const std::string& name) {
  std::vector<float> values = valuesOf(tensor);
  const auto bad =
      std::find_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); });
  if (bad != values.end()) {
    failInput("{}: tensor '{}': value {} is not finite; the training diverged, train again", name,
              key, bad - values.begin());
  }
  return values;
}

DenseLayer layerOf(const Tensors& tensors, std::size_t index, std::size_t inputs,
                   const std::string& name) {
  const std::string key = weightName(index);
  const Tensor& weight = tensorNamed(tensors, key, 2, name);
  const Tensor& bias = tensorNamed(tensors, biasName(index), 1, name);
  const std::size_t outputs = weight.shape[0];
  if (weight.shape[1] != inputs) {
    failInput("{}: tensor '{}': takes {}, {} {}; {}", name, key, counted(weight.shape[1], "input"),
              index == 0 ? "the number of features is" : "the layer before gives", inputs,
              kExportAgain);
  }
  if (outputs == 0 || outputs > kMaxWidth) {
    failInput("{}: tensor '{}': has {}, not 1 to {}; train another network", name, key,
              counted(outputs, "output"), kMaxWidth);
  }
  if (bias.shape[0] != outputs) {
    failInput("{}: tensor '{}': has {} for {}; {}", name, biasName(index),
              counted(bias.shape[0], "value"), counted(outputs, "output"), kExportAgain);
  }
  return {.inputs = static_cast<int>(inputs),
          .outputs = static_cast<int>(outputs),
          .weights = finiteValues(weight, key, name),
          .bias = finiteValues(bias, biasName(index), name)};
}

/// The layers that follow one another from 0. Fails where a tensor belongs to none of them.
std::size_t layersNamed(const Tensors& tensors, const std::string& name) {
  std::size_t count = 0;
  while (tensors.contains(weightName(count)) || tensors.contains(biasName(count))) ++count;
  if (count > kMaxLayers) {
    failInput("{}: tensor '{}': is layer {} of at most {}; train a network of fewer layers", name,
              weightName(kMaxLayers), kMaxLayers + 1, kMaxLayers);
  }
  for (const auto& [key, tensor] : tensors) {
    bool known = false;
    for (std::size_t i = 0; i < count; ++i) {
      known = known || key == weightName(i) || key == biasName(i);
    }
    if (!known) {
      failInput("{}: tensor '{}': belongs to no layer; name them {}, {}, {} and so on, no others",
                name, settings::shownText(key), weightName(0), biasName(0), weightName(1));
    }
  }
  return count;
}

}  // namespace

std::vector<DenseLayer> layersOf(const Tensors& tensors, std::size_t inputs, std::size_t outputs,
                                 const std::string& name) {
  // With no layer at all, it is the first that is missing.
  const std::size_t count = std::max<std::size_t>(layersNamed(tensors, name), 1);
  std::vector<DenseLayer> layers;
  std::size_t values = inputs;
  for (std::size_t i = 0; i < count; ++i) {
    layers.push_back(layerOf(tensors, i, values, name));
    values = static_cast<std::size_t>(layers.back().outputs);
  }
  if (values != outputs) {
    failInput("{}: tensor '{}': gives {}, __metadata__ names {}; {}", name, weightName(count - 1),
              counted(values, "output"), outputs, kExportAgain);
  }
  return layers;
}

}  // namespace macula::network
