#include "passes/oit/learned/network_layout.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/gl/shader_source.h"
#include "shared/network.h"

namespace macula::passes {
namespace {

/// Twice those of the thesis's network: they take a driver's compiler some seconds, and a frame
/// milliseconds.
constexpr std::size_t kMostWeights = 20'000;

std::vector<std::string> thesisFeatures() {
  return {"fragments_share", "reserved_share", "near",    "far",       "scene_near", "scene_far",
          "blend_r",         "blend_g",        "blend_b", "nearest_r", "nearest_g",  "nearest_b"};
}

std::vector<std::string> learnedFeatures() {
  std::vector<std::string> names{"log_fragments"};
  const auto forSlices = [&](const char* name) {
    for (int i = 0; i < LEARNED_SLICES; ++i) names.push_back(fmt::format("{}_{}", name, i));
  };
  forSlices("log_error");
  forSlices("passes");
  forSlices("share");
  forSlices("log_thickness");
  for (int i = 0; i < LEARNED_SLICES; ++i) {
    for (const char channel : {'r', 'g', 'b'})
      names.push_back(fmt::format("color_{}_{}", i, channel));
  }
  for (const char channel : {'r', 'g', 'b'}) names.push_back(fmt::format("behind_{}", channel));
  return names;
}

/// bias + sum of weight * name_i of one output.
std::string sumOf(const network::DenseLayer& layer, std::size_t output, char name) {
  std::string text = gl::literal(layer.bias[output]);
  const auto inputs = static_cast<std::size_t>(layer.inputs);
  for (std::size_t i = 0; i < inputs; ++i) {
    const float weight = layer.weights[output * inputs + i];
    if (weight != 0.0F) text += fmt::format("+{}{}*{}", name, i, gl::literal(weight));
  }
  return text;
}

/// The network as statements on one line that compute y[] from x[]; the mirror of
/// network::evaluate().
std::string bodyOf(const network::Network& network) {
  std::string body;
  for (std::size_t i = 0; i < network.features.size(); ++i) {
    body += fmt::format("float a{0}=(x[{0}]-{1})*{2};", i, gl::literal(network.mean[i]),
                        gl::literal(network.scale[i]));
  }
  char name = 'a';
  for (std::size_t l = 0; l + 1 < network.layers.size(); ++l, ++name) {
    const network::DenseLayer& layer = network.layers[l];
    for (std::size_t o = 0; o < static_cast<std::size_t>(layer.outputs); ++o) {
      body += fmt::format("float {}{}=max(0.0,{});", static_cast<char>(name + 1), o,
                          sumOf(layer, o, name));
    }
  }
  const bool sigmoid = network.outputActivation == network::OutputActivation::Sigmoid;
  for (std::size_t o = 0; o < network.outputs.size(); ++o) {
    const std::string sum = sumOf(network.layers.back(), o, name);
    body += sigmoid ? fmt::format("y[{}]=1.0/(1.0+exp(-({})));", o, sum)
                    : fmt::format("y[{}]={};", o, sum);
  }
  return body;
}

std::size_t weightsOf(const network::Network& network) {
  std::size_t weights = 0;
  for (const network::DenseLayer& layer : network.layers) weights += layer.weights.size();
  return weights;
}

void checkNames(const std::vector<std::string>& expected, const std::vector<std::string>& found,
                const char* what, const std::filesystem::path& file) {
  if (found == expected) return;
  failInput("{}: its {} are '{}', not '{}'; train it for this version", file.string(), what,
            fmt::join(found, ","), fmt::join(expected, ","));
}

}  // namespace

std::string_view nameOf(NetworkModel model) {
  return model == NetworkModel::Thesis ? "thesis" : "macula";
}

std::vector<std::string> featuresOf(NetworkModel model) {
  return model == NetworkModel::Thesis ? thesisFeatures() : learnedFeatures();
}

std::vector<std::string> outputsOf(NetworkModel model) {
  if (model == NetworkModel::Thesis) return {"importance"};
  std::vector<std::string> names;
  for (const char* name : {"error", "order"}) {
    for (int i = 0; i < LEARNED_KNOTS; ++i) names.push_back(fmt::format("{}_{}", name, i));
  }
  return names;
}

std::filesystem::path defaultNetworkFile(NetworkModel model) {
  return dataFolder("assets") / "networks" / fmt::format("{}.safetensors", nameOf(model));
}

network::Network readNetworkOf(NetworkModel model, const std::filesystem::path& file) {
  network::Network network = network::readNetwork(file);
  if (network.model != nameOf(model)) {
    failInput(
        "{}: it is a network for '{}', and this method needs one for '{}'; choose another "
        "oit.network",
        file.string(), network.model, nameOf(model));
  }
  checkNames(featuresOf(model), network.features, "features", file);
  checkNames(outputsOf(model), network.outputs, "outputs", file);
  if (weightsOf(network) > kMostWeights) {
    failInput(
        "{}: {} weights are more than the {} that are written into a shader; train a smaller "
        "network",
        file.string(), weightsOf(network), kMostWeights);
  }
  return network;
}

const network::Network& LoadedNetwork::get(NetworkModel model,
                                           const std::filesystem::path& chosen) {
  const std::filesystem::path file = chosen.empty() ? defaultNetworkFile(model) : chosen;
  if (!network_ || file != file_ || network_->model != nameOf(model)) {
    network_ = readNetworkOf(model, file);
    file_ = file;
  }
  return *network_;
}

gl::Defines networkDefines(const network::Network& network, NetworkModel model, int sliceTile) {
  gl::Defines defines{{"INPUTS", std::to_string(network.features.size())},
                      {"OUTPUTS", std::to_string(network.outputs.size())},
                      {"SLICES", std::to_string(LEARNED_SLICES)},
                      {"SLICE_TILE", std::to_string(sliceTile)},
                      {"NETWORK_BODY", bodyOf(network)}};
  defines.emplace_back(model == NetworkModel::Thesis ? "MODEL_THESIS" : "MODEL_LEARNED", "1");
  return defines;
}

}  // namespace macula::passes
