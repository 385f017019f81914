// Networks of importance: what a file must hold for a model, and the text that shaders get of it.
#include "passes/oit/learned/network_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <limits>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "model_network.h"
#include "shared/network.h"
#include "temporary_path.h"

namespace macula::passes {
namespace {

using network::DenseLayer;
using network::Network;
using network::OutputActivation;
using testing::HasSubstr;
using testing::StartsWith;

constexpr NetworkModel kModels[]{NetworkModel::Thesis, NetworkModel::Learned};

std::string defineOf(const gl::Defines& defines, const std::string& key) {
  for (const auto& [name, value] : defines) {
    if (name == key) return value;
  }
  return "(none)";
}

std::string bodyOf(const Network& network) {
  return defineOf(networkDefines(network, NetworkModel::Learned, 1), "NETWORK_BODY");
}

/// said = bias + weight * (x - mean) * scale.
Network line(float mean, float scale, float weight, float bias) {
  return {.model = "macula",
          .features = {"x"},
          .outputs = {"y"},
          .mean = {mean},
          .scale = {scale},
          .layers = {{.inputs = 1, .outputs = 1, .weights = {weight}, .bias = {bias}}},
          .command = "",
          .dataHash = ""};
}

TEST(NetworkModels, SeeTheFeaturesThatTheShadersAdd) {
  const std::vector<std::string> thesis = featuresOf(NetworkModel::Thesis);
  ASSERT_EQ(thesis.size(), static_cast<std::size_t>(THESIS_FEATURES));
  EXPECT_EQ(thesis[1], "reserved_share");
  EXPECT_EQ(thesis[9], "nearest_r");
  EXPECT_EQ(outputsOf(NetworkModel::Thesis), std::vector<std::string>{"importance"});
  const std::vector<std::string> learned = featuresOf(NetworkModel::Learned);
  ASSERT_EQ(learned.size(), static_cast<std::size_t>(LEARNED_FEATURES));
  // The places that shaders/lib/learned_features.glsl writes to.
  EXPECT_EQ(learned[0], "log_fragments");
  EXPECT_EQ(learned[1], "log_error_0");
  EXPECT_EQ(learned[9], "passes_0");
  EXPECT_EQ(learned[17], "share_0");
  EXPECT_EQ(learned[25], "log_thickness_0");
  EXPECT_EQ(learned[33 + 3 * 2 + 1], "color_2_g");
  EXPECT_EQ(learned[59], "behind_b");
  EXPECT_EQ(outputsOf(NetworkModel::Learned),
            (std::vector<std::string>{"error_0", "error_1", "error_2", "error_3", "order_0",
                                      "order_1", "order_2", "order_3"}));
}

TEST(NetworkModels, HaveFilesThatFitThem) {
  for (const NetworkModel model : kModels) {
    const Network network = readNetworkOf(model, defaultNetworkFile(model));
    EXPECT_EQ(network.model, nameOf(model));
    EXPECT_EQ(network.outputActivation == OutputActivation::Sigmoid, model == NetworkModel::Thesis);
  }
}

TEST(NetworkModels, ShipWithWeightsThatWereTrained) {
  for (const NetworkModel model : kModels) {
    const std::filesystem::path file = defaultNetworkFile(model);
    EXPECT_NE(readNetworkOf(model, file).dataHash, std::string(64, '0'))
        << file << " holds placeholders: train it (tools/train/train.py)";
  }
}

class NetworkFiles : public testing::Test {
 protected:
  ~NetworkFiles() override { std::filesystem::remove(path_); }
  std::filesystem::path write(const Network& network) {
    writeFileAtomically(path_, test::fileOf(network));
    return path_;
  }
  /// @param words each part of the message
  void expectRefused(NetworkModel model, const Network& network,
                     const std::vector<std::string>& words) {
    try {
      static_cast<void>(readNetworkOf(model, write(network)));
      ADD_FAILURE() << "accepted: " << words.front();
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), StartsWith(path_.string() + ": "));
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "one line";
      for (const std::string& word : words) EXPECT_THAT(error.what(), HasSubstr(word));
    }
  }

 private:
  std::filesystem::path path_ = test::temporaryPath("net.safetensors");
};

TEST_F(NetworkFiles, ReadBackAsTheyWere) {
  for (const NetworkModel model : kModels) {
    const Network made = test::randomNetwork(model, {8, 4}, 3);
    const Network read = readNetworkOf(model, write(made));
    EXPECT_EQ(read.mean, made.mean);
    EXPECT_EQ(read.scale, made.scale);
    EXPECT_EQ(read.outputActivation, made.outputActivation);
    ASSERT_EQ(read.layers.size(), 3U);
    EXPECT_EQ(read.layers[1].weights, made.layers[1].weights);
    EXPECT_EQ(read.layers[2].bias, made.layers[2].bias);
  }
}

TEST_F(NetworkFiles, OfAnotherModelAreRefused) {
  const Network thesis = test::randomNetwork(NetworkModel::Thesis, {4}, 1);
  const Network learned = test::randomNetwork(NetworkModel::Learned, {4}, 1);
  expectRefused(NetworkModel::Learned, thesis,
                {"a network for 'thesis'", "needs one for 'macula'", "choose another oit.network"});
  expectRefused(NetworkModel::Thesis, learned,
                {"a network for 'macula'", "needs one for 'thesis'", "choose another oit.network"});
}

TEST_F(NetworkFiles, WithOtherFeaturesOrOutputsAreRefused) {
  for (const NetworkModel model : kModels) {
    Network other = test::randomNetwork(model, {4}, 1);
    std::swap(other.features[2], other.features[3]);
    expectRefused(model, other, {"its features are", "train it for this version"});
    other = test::randomNetwork(model, {4}, 1);
    other.features.back() = "weather";
    expectRefused(model, other, {"its features are", "weather"});
    other = test::randomNetwork(model, {4}, 1);
    other.outputs.front() = "weather";
    expectRefused(model, other, {"its outputs are 'weather", "train it for this version"});
  }
}

TEST_F(NetworkFiles, WithMoreWeightsThanAShaderTakesAreRefused) {
  // 12 * 200 + 200 * 88 + 88 = 20,088.
  expectRefused(NetworkModel::Thesis, test::randomNetwork(NetworkModel::Thesis, {200, 88}, 1),
                {"20088 weights", "20000", "train a smaller network"});
  // 12 * 100 + 100 * 186 + 186 = 19,986.
  EXPECT_NO_THROW(static_cast<void>(readNetworkOf(
      NetworkModel::Thesis, write(test::randomNetwork(NetworkModel::Thesis, {100, 186}, 1)))));
}

TEST_F(NetworkFiles, ThatAreNotThereAreRefused) {
  EXPECT_THROW(static_cast<void>(readNetworkOf(NetworkModel::Thesis, "nowhere.safetensors")),
               InputError);
}

TEST(NetworkText, OfASmallNetworkIsExactlyThis) {
  // Two inputs, two hidden values, one output; the weight 0 is left out.
  const Network network{
      .model = "macula",
      .features = {"p", "q"},
      .outputs = {"y"},
      .mean = {1.0F, -2.0F},
      .scale = {0.5F, 2.0F},
      .layers = {{.inputs = 2,
                  .outputs = 2,
                  .weights = {1.0F, -2.5F, 0.0F, 3.0F},
                  .bias = {0.25F, -1.0F}},
                 {.inputs = 2, .outputs = 1, .weights = {-4.0F, 0.125F}, .bias = {7.0F}}},
      .command = "",
      .dataHash = ""};
  const std::string hidden =
      "float a0=(x[0]-1.0)*0.5;float a1=(x[1]-(-2.0))*2.0;"
      "float b0=max(0.0,0.25+a0*1.0+a1*(-2.5));float b1=max(0.0,(-1.0)+a1*3.0);";
  EXPECT_EQ(bodyOf(network), hidden + "y[0]=7.0+b0*(-4.0)+b1*0.125;");
  Network sigmoid = network;
  sigmoid.outputActivation = OutputActivation::Sigmoid;
  EXPECT_EQ(bodyOf(sigmoid), hidden + "y[0]=1.0/(1.0+exp(-(7.0+b0*(-4.0)+b1*0.125)));");
  // The same by network::evaluate: x = (2, -1), a = (0.5, 2), b = (0, 5).
  EXPECT_EQ(network::evaluate(network, std::vector{2.0F, -1.0F}), std::vector{7.625F});
}

TEST(NetworkText, HasEveryOutput) {
  Network network = line(0.0F, 1.0F, 1.0F, 0.0F);
  network.outputs = {"y", "z"};
  network.layers[0] = {.inputs = 1, .outputs = 2, .weights = {2.0F, 3.0F}, .bias = {4.0F, 5.0F}};
  EXPECT_EQ(bodyOf(network), "float a0=(x[0]-0.0)*1.0;y[0]=4.0+a0*2.0;y[1]=5.0+a0*3.0;");
}

TEST(NetworkText, WritesNumbersThatReadBackAsTheSameFloats) {
  EXPECT_THAT(bodyOf(line(0, 1, 1e-30F, 0)), HasSubstr("a0*1e-30;"));
  constexpr float kLeast = std::numeric_limits<float>::denorm_min();
  EXPECT_THAT(bodyOf(line(0, 1, kLeast, 0)), HasSubstr("a0*1.40129846e-45;"));
  EXPECT_THAT(bodyOf(line(0, 1, -8e9F, 0)), HasSubstr("a0*(-8e+09);"));
  EXPECT_THAT(bodyOf(line(0, 1, 16777216.0F, 0)), HasSubstr("a0*16777216.0;"));
  EXPECT_THAT(bodyOf(line(0, 1, 1, 0.1F)), HasSubstr("y[0]=0.100000001+"));
  const Network random = test::randomNetwork(NetworkModel::Thesis, {3}, 7);
  const std::string text = bodyOf(random);
  // a0 = (x[0] - mean) * scale, and the first weight of the last layer.
  const auto after = [&](const std::string& word) {
    std::size_t at = text.find(word) + word.size();
    if (text[at] == '(') ++at;
    return std::strtof(text.c_str() + at, nullptr);
  };
  EXPECT_EQ(after("x[0]-"), random.mean[0]);
  EXPECT_EQ(after("b0="), 0.0F) << "the max";
  EXPECT_EQ(after("max(0.0,"), random.layers[0].bias[0]);
  EXPECT_EQ(after("+b2*"), random.layers[1].weights[2]);
}

TEST(NetworkText, OfMinusZeroIsNoDecrement) {
  // "x[0]--0.0" would take one off x[0].
  EXPECT_EQ(bodyOf(line(-0.0F, 1.0F, 1.0F, -0.0F)),
            "float a0=(x[0]-(-0.0))*1.0;y[0]=(-0.0)+a0*1.0;");
}

TEST(NetworkDefines, SayModelSizesAndSlices) {
  const Network thesis = test::randomNetwork(NetworkModel::Thesis, {2}, 1);
  gl::Defines defines = networkDefines(thesis, NetworkModel::Thesis, 2);
  EXPECT_EQ(defineOf(defines, "INPUTS"), "12");
  EXPECT_EQ(defineOf(defines, "OUTPUTS"), "1");
  EXPECT_EQ(defineOf(defines, "SLICE_TILE"), "2");
  EXPECT_EQ(defineOf(defines, "MODEL_THESIS"), "1");
  EXPECT_EQ(defineOf(defines, "MODEL_LEARNED"), "(none)");
  const Network learned = test::randomNetwork(NetworkModel::Learned, {2}, 1);
  defines = networkDefines(learned, NetworkModel::Learned, 4);
  EXPECT_EQ(defineOf(defines, "INPUTS"), "60");
  EXPECT_EQ(defineOf(defines, "OUTPUTS"), "8");
  EXPECT_EQ(defineOf(defines, "MODEL_LEARNED"), "1");
  EXPECT_EQ(defineOf(defines, "MODEL_THESIS"), "(none)");
  EXPECT_EQ(defineOf(defines, "NETWORK_BODY").find('\n'), std::string::npos) << "one line";
}

}  // namespace
}  // namespace macula::passes
