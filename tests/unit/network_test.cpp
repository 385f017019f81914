// Networks from files: what is read, what it evaluates to, half precision, limits.
#include "engine/network/network.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/network/safetensors.h"
#include "tests/unit/network_builder.h"
#include "tests/unit/temporary_path.h"

namespace macula::network {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two layers, each byte as it stands in the file: the one case without the builder.
TEST(Network, ReadsAFileWrittenByteByByte) {
  const std::string header =
      R"({"__metadata__":{"format":"macula-network","version":"1","model":"m","features":"a",)"
      R"("outputs":"b","mean":"0","scale":"1","activation":"relu","output_activation":"none",)"
      R"("command":"c","data":")" +
      std::string(64, '0') +
      R"("},)"
      R"("layer1.bias":{"dtype":"F32","shape":[1],"data_offsets":[0,4]},)"
      R"("layer0.weight":{"dtype":"F32","shape":[2,1],"data_offsets":[4,12]},)"
      R"("layer0.bias":{"dtype":"F32","shape":[2],"data_offsets":[12,20]},)"
      R"("layer1.weight":{"dtype":"F16","shape":[1,2],"data_offsets":[20,24]}}  )";
  ASSERT_GT(header.size(), 256U);
  ASSERT_LT(header.size(), 768U);
  const std::array<unsigned char, 8> length = {static_cast<unsigned char>(header.size() % 256),
                                               static_cast<unsigned char>(header.size() / 256),
                                               0,
                                               0,
                                               0,
                                               0,
                                               0,
                                               0};
  const std::array<unsigned char, 24> data = {
      0x00, 0x00, 0x80, 0x3F,  // layer1.bias: 1
      0x00, 0x00, 0x00, 0x40,  // layer0.weight: 2
      0x00, 0x00, 0x80, 0xBF,  // -1
      0x00, 0x00, 0x40, 0x40,  // layer0.bias: 3
      0x00, 0x00, 0x00, 0x3F,  // 0.5
      0x00, 0x3E, 0x00, 0xC4,  // layer1.weight: 1.5, -4
  };
  const std::string bytes =
      std::string(length.begin(), length.end()) + header + std::string(data.begin(), data.end());
  const Network network = test::parse(bytes);
  ASSERT_EQ(network.layers.size(), 2U);
  EXPECT_THAT(network.layers[0].weights, ElementsAre(2.0F, -1.0F));
  EXPECT_THAT(network.layers[0].bias, ElementsAre(3.0F, 0.5F));
  EXPECT_THAT(network.layers[1].weights, ElementsAre(1.5F, -4.0F));
  EXPECT_THAT(network.layers[1].bias, ElementsAre(1.0F));
  // a = 1: hidden 2 + 3 = 5 and -1 + 0.5 < 0, out 1 + 1.5 x 5.
  EXPECT_THAT(evaluate(network, std::array{1.0F}), ElementsAre(8.5F));
  // a = -1: hidden -2 + 3 = 1 and 1 + 0.5 = 1.5, out 1 + 1.5 - 6.
  EXPECT_THAT(evaluate(network, std::array{-1.0F}), ElementsAre(-3.5F));
}

TEST(Network, HoldsWhatTheFileSays) {
  const Network network = test::parse(test::smallFile().bytes());
  EXPECT_EQ(network.model, "thesis");
  EXPECT_THAT(network.features, ElementsAre("depth", "normal"));
  EXPECT_THAT(network.outputs, ElementsAre("near", "far"));
  EXPECT_THAT(network.mean, ElementsAre(1.0F, -2.0F));
  EXPECT_THAT(network.scale, ElementsAre(0.5F, 2.0F));
  EXPECT_EQ(network.outputActivation, OutputActivation::None);
  EXPECT_EQ(network.command, "train.py --seed 1");
  EXPECT_EQ(network.dataHash, std::string(64, 'a'));
  ASSERT_EQ(network.layers.size(), 2U);
  EXPECT_EQ(network.layers[0].inputs, 2);
  EXPECT_EQ(network.layers[0].outputs, 3);
  EXPECT_EQ(network.layers[1].inputs, 3);
  EXPECT_EQ(network.layers[1].outputs, 2);
}

TEST(Network, EvaluatesWhatWasComputedByHand) {
  // (3, -1.5) is normalised to (1, 1). Hidden sums: 0.5 + 1 + 2 = 3.5, 1 - 1 - 3 = -3, cut to 0,
  // and 1 + 0.5 + 0.25 = 1.75. Outputs: 7 + 0 - 7 = 0 and -3.25 + 3.5 + 0 + 1.75 = 2.
  const std::array features = {3.0F, -1.5F};
  test::NetworkFile file = test::smallFile();
  EXPECT_THAT(evaluate(test::parse(file.bytes()), features), ElementsAre(0.0F, 2.0F));
  file.header["__metadata__"]["output_activation"] = "sigmoid";
  const std::vector<float> shares = evaluate(test::parse(file.bytes()), features);
  ASSERT_EQ(shares.size(), 2U);
  EXPECT_EQ(shares[0], 0.5F);
  EXPECT_NEAR(shares[1], 0.88079708F, 1e-7F);
}

TEST(Network, SigmoidStaysFiniteFarFromZero) {
  test::NetworkFile file;
  file.header["__metadata__"] = test::metadataOf("a", "b", "0", "1");
  file.header["__metadata__"]["output_activation"] = "sigmoid";
  file.addF32("layer0.weight", {1, 1}, {1});
  file.addF32("layer0.bias", {1}, {0});
  const Network network = test::parse(file.bytes());
  EXPECT_THAT(evaluate(network, std::array{-1000.0F}), ElementsAre(0.0F));
  EXPECT_THAT(evaluate(network, std::array{1000.0F}), ElementsAre(1.0F));
}

TEST(Network, EvaluateWantsEveryFeature) {
  const Network network = test::parse(test::smallFile().bytes());
  EXPECT_THROW(static_cast<void>(evaluate(network, std::array{1.0F})), std::invalid_argument);
}

TEST(Network, FurtherMetadataIsLeftAlone) {
  test::NetworkFile file = test::smallFile();
  file.header["__metadata__"]["epochs"] = "20";
  EXPECT_EQ(test::parse(file.bytes()).layers.size(), 2U);
}

TEST(Network, HalvesAreExact) {
  const auto floatOfHalf = [](std::uint16_t half) {
    const std::array bytes{static_cast<std::byte>(half & 0xFFU),
                           static_cast<std::byte>(half >> 8U)};
    return valuesOf({.type = ScalarType::F16, .shape = {1}, .bytes = bytes}).at(0);
  };
  EXPECT_EQ(floatOfHalf(0x3C00), 1.0F);
  EXPECT_EQ(floatOfHalf(0x3C01), 1.0F + 0x1p-10F);
  EXPECT_EQ(floatOfHalf(0xC000), -2.0F);
  EXPECT_EQ(floatOfHalf(0x7BFF), 65504.0F);    // the largest
  EXPECT_EQ(floatOfHalf(0x0400), 0x1p-14F);    // the least normal
  EXPECT_EQ(floatOfHalf(0x03FF), 0x3FFp-24F);  // the largest subnormal
  EXPECT_EQ(floatOfHalf(0x8001), -0x1p-24F);   // the least subnormal
  EXPECT_TRUE(std::signbit(floatOfHalf(0x8000)));
  EXPECT_EQ(floatOfHalf(0x8000), 0.0F);
  EXPECT_EQ(floatOfHalf(0xFC00), -std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::isnan(floatOfHalf(0x7C01)));
}

TEST(Network, ReadsHalfPrecision) {
  test::NetworkFile file;
  file.header["__metadata__"] = test::metadataOf("a,b", "c", "0 0", "1 1");
  file.addF16("layer0.weight", {1, 2}, {0x3C00, 0xC000});
  file.addF32("layer0.bias", {1}, {0.25F});
  EXPECT_THAT(evaluate(test::parse(file.bytes()), std::array{8.0F, 0.5F}), ElementsAre(7.25F));
}

/// `layers` layers of `width` values; `features` inputs.
test::NetworkFile wideFile(std::size_t features, std::size_t width, std::size_t layers) {
  std::string names, outputs, zeros, ones;
  for (std::size_t i = 0; i < features; ++i) {
    names += (i == 0 ? "f" : ",f") + std::to_string(i);
    zeros += i == 0 ? "0" : " 0";
    ones += i == 0 ? "1" : " 1";
  }
  for (std::size_t i = 0; i < width; ++i) outputs += (i == 0 ? "o" : ",o") + std::to_string(i);
  test::NetworkFile file;
  file.header["__metadata__"] = test::metadataOf(names, outputs, zeros, ones);
  std::size_t inputs = features;
  for (std::size_t i = 0; i < layers; ++i) {
    const std::string layer = "layer" + std::to_string(i);
    file.addF32(layer + ".weight", {width, inputs}, std::vector<float>(width * inputs, 0.5F));
    file.addF32(layer + ".bias", {width}, std::vector<float>(width, 0.0F));
    inputs = width;
  }
  return file;
}

std::string messageOf(const std::string& bytes) {
  try {
    static_cast<void>(test::parse(bytes));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Network, LimitsAreReachedAndHeld) {
  EXPECT_EQ(messageOf(wideFile(kMaxInputs, kMaxWidth, kMaxLayers).bytes()), "no error");
  EXPECT_THAT(messageOf(wideFile(kMaxInputs + 1, 1, 1).bytes()),
              HasSubstr("'features' holds 65 names, the limit is 64; train a smaller network"));
  EXPECT_THAT(messageOf(wideFile(1, kMaxWidth + 1, 1).bytes()),
              HasSubstr("'outputs' holds 257 names, the limit is 256"));
  EXPECT_THAT(
      messageOf(wideFile(1, 1, kMaxLayers + 1).bytes()),
      HasSubstr("tensor 'layer8.weight': is layer 9 of at most 8; train a network of fewer"));
  test::NetworkFile hidden = test::smallFile();  // the hidden layer alone is too wide
  hidden.header.erase("layer0.weight");
  hidden.header.erase("layer0.bias");
  hidden.header.erase("layer1.weight");
  hidden.header.erase("layer1.bias");
  hidden.data.clear();
  hidden.addF32("layer0.weight", {257, 2}, std::vector<float>(514, 0.0F));
  hidden.addF32("layer0.bias", {257}, std::vector<float>(257, 0.0F));
  EXPECT_THAT(messageOf(hidden.bytes()),
              HasSubstr("tensor 'layer0.weight': has 257 outputs, not 1 to 256; train another"));
  EXPECT_THAT(messageOf(std::string(kMaxFileBytes + 1, ' ')),
              HasSubstr("the file has 4194305 bytes, the limit is 4194304"));
}

TEST(Network, TheFuzzTargetBeginsWithNetworks) {
  const std::filesystem::path corpus = MACULA_SOURCE_DIR "/tests/fuzz/corpus/network";
  EXPECT_EQ(readNetwork(corpus / "two_layers.safetensors").layers.size(), 2U);
  EXPECT_EQ(readNetwork(corpus / "half.safetensors").layers[0].bias[1], 65504.0F);
}

TEST(Network, ReadsFromDiskAndNamesThePath) {
  const std::string path = macula::test::temporaryPath("net.safetensors");
  writeFileAtomically(path, test::smallFile().bytes());
  EXPECT_EQ(readNetwork(path).model, "thesis");
  writeFileAtomically(path, std::string(kMaxFileBytes + 1, ' '));
  EXPECT_THAT([&] { static_cast<void>(readNetwork(path)); },
              testing::ThrowsMessage<InputError>(testing::StartsWith(path + ": the file has")));
  std::filesystem::remove(path);
  EXPECT_THAT([&] { static_cast<void>(readNetwork(path)); },
              testing::ThrowsMessage<InputError>(HasSubstr(path + ": no such file")));
}

}  // namespace
}  // namespace macula::network
