// Networks in the shader against network::evaluate() and the program that trained them.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "engine/core/file.h"
#include "engine/network/safetensors.h"
#include "gl_fixture.h"
#include "model_network.h"
#include "oit_cases.h"
#include "passes/oit/learned/read_features.h"

namespace macula::test {
namespace {

using passes::NetworkModel;

/// Largest |a - b| / max(1, |b|); infinite where a value is none.
double largestRelative(const std::vector<float>& a, const std::vector<float>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const double off = std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])) /
                       std::max(1.0, std::abs(static_cast<double>(b[i])));
    largest = std::isfinite(off) ? std::max(largest, off) : INFINITY;
  }
  return largest;
}

std::vector<float> evaluateAll(const network::Network& network,
                               const std::vector<float>& features) {
  std::vector<float> predicted;
  const std::size_t inputs = network.features.size();
  for (std::size_t at = 0; at < features.size(); at += inputs) {
    const std::vector<float> one =
        network::evaluate(network, std::span(features).subspan(at, inputs));
    predicted.insert(predicted.end(), one.begin(), one.end());
  }
  return predicted;
}

std::vector<float> randomFeatures(const network::Network& network, std::size_t count,
                                  std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<float> features(count * network.features.size());
  for (float& x : features) x = static_cast<float>(random() >> 8U) / 2097152.0F - 4.0F;  // -4 .. 4
  return features;
}

class NetworkOnGpu : public GlTest {};

struct Shape {
  NetworkModel model;
  std::vector<int> hidden;
};

TEST_F(NetworkOnGpu, SaysWhatItSaysOnTheCpu) {
  // The thesis's network, Macula's, one without a hidden layer, and a deep one.
  const std::vector<Shape> shapes{{NetworkModel::Thesis, {128, 64}},
                                  {NetworkModel::Learned, {32, 32}},
                                  {NetworkModel::Learned, {}},
                                  {NetworkModel::Thesis, {8, 7, 6, 5, 4, 3, 2}}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const network::Network network =
        randomNetwork(shapes[i].model, shapes[i].hidden, static_cast<std::uint32_t>(i));
    // No multiple of a work-group.
    const std::vector<float> features = randomFeatures(network, 300, 5);
    const std::vector<float> there =
        passes::evaluateOnGpu(network, shapes[i].model, features, device().programs);
    const std::vector<float> here = evaluateAll(network, features);
    ASSERT_EQ(there.size(), 300U * network.outputs.size());
    EXPECT_LT(largestRelative(there, here), 1e-5) << "network " << i;
    const auto [least, most] = std::minmax_element(here.begin(), here.end());
    EXPECT_GT(*most - *least, 0.01F) << "its outputs vary";
    note("largest difference of network " + std::to_string(i), largestRelative(there, here));
  }
}

TEST_F(NetworkOnGpu, SaysNothingInfiniteOfFarFeatures) {
  const network::Network network = randomNetwork(NetworkModel::Thesis, {16}, 9);
  std::vector<float> features = randomFeatures(network, 64, 6);
  for (float& x : features) x *= 1e5F;  // the sigmoid is at its ends
  const std::vector<float> predicted =
      passes::evaluateOnGpu(network, NetworkModel::Thesis, features, device().programs);
  EXPECT_LT(largestRelative(predicted, evaluateAll(network, features)), 1e-5);
  EXPECT_THAT(predicted, testing::Each(testing::AllOf(testing::Ge(0.0F), testing::Le(1.0F))));
}

TEST_F(NetworkOnGpu, TakesAMeanOfMinusZero) {
  network::Network network = randomNetwork(NetworkModel::Thesis, {2}, 9);
  network.mean[0] = -0.0F;
  const std::vector<float> features = randomFeatures(network, 8, 6);
  EXPECT_LT(largestRelative(
                passes::evaluateOnGpu(network, NetworkModel::Thesis, features, device().programs),
                evaluateAll(network, features)),
            1e-5);
}

class Probes : public NetworkOnGpu, public testing::WithParamInterface<NetworkModel> {};

/// Inputs and what PyTorch predicts from them, written by tools/train/train.py --probes with the
/// weights.
TEST_P(Probes, AreAnsweredAsByTheProgramThatTrained) {
  const std::filesystem::path file =
      dataFolder("tests") / "golden" / "networks" /
      (std::string(passes::nameOf(GetParam())) + "_probes.safetensors");
  ASSERT_TRUE(std::filesystem::exists(file))
      << file << " is missing: write it with the weights, by tools/train/train.py --probes";
  const network::Network network =
      passes::readNetworkOf(GetParam(), passes::defaultNetworkFile(GetParam()));
  const std::string text = readTextFile(file);
  const network::Container container =
      network::parseSafetensors(std::as_bytes(std::span(text.data(), text.size())), file.string());
  ASSERT_THAT(container.tensors, testing::Contains(testing::Key("features")));
  ASSERT_THAT(container.tensors, testing::Contains(testing::Key("outputs")));
  const network::Tensor& inputs = container.tensors.at("features");
  constexpr std::size_t kProbes = 1000;
  EXPECT_EQ(inputs.type, network::ScalarType::F16);
  ASSERT_EQ(inputs.shape, (std::vector<std::size_t>{kProbes, network.features.size()}));
  ASSERT_EQ(container.tensors.at("outputs").shape,
            (std::vector<std::size_t>{kProbes, network.outputs.size()}));
  const std::vector<float> features = network::valuesOf(inputs);
  const std::vector<float> expected = network::valuesOf(container.tensors.at("outputs"));
  const double onCpu = largestRelative(evaluateAll(network, features), expected);
  const double onGpu = largestRelative(
      passes::evaluateOnGpu(network, GetParam(), features, device().programs), expected);
  EXPECT_LT(onCpu, 1e-4) << "the probes are of other weights: write both again";
  EXPECT_LT(onGpu, 1e-4);
  note("largest difference on the CPU", onCpu);
  note("largest difference on the GPU", onGpu);
}

INSTANTIATE_TEST_SUITE_P(Networks, Probes,
                         testing::Values(NetworkModel::Thesis, NetworkModel::Learned),
                         [](const auto& model) {
                           return std::string(passes::nameOf(model.param));
                         });

}  // namespace
}  // namespace macula::test
