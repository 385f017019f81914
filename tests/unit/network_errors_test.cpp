// Files that are no network, or a broken one: each refused with file, place and fix.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "tests/unit/network_builder.h"

namespace macula::network {
namespace {

using nlohmann::json;
using test::NetworkFile;
using testing::HasSubstr;
using testing::StartsWith;

/// One way to spoil a good file, and what is to be said about it.
struct Case {
  std::string name;
  std::function<std::string()> bytes;
  std::string place;
  std::string what;
  std::string fix;
};

void PrintTo(const Case& spoilt, std::ostream* out) {
  *out << spoilt.name;
}

std::string spoilt(const std::function<void(NetworkFile&)>& spoil) {
  NetworkFile file = test::smallFile();
  spoil(file);
  return file.bytes();
}

/// A case that changes the file before it is put together.
Case file(std::string name, std::function<void(NetworkFile&)> spoil, std::string place,
          std::string what, std::string fix = "export the network again") {
  return {std::move(name), [spoil = std::move(spoil)] { return spoilt(spoil); }, std::move(place),
          std::move(what), std::move(fix)};
}

/// A case that sets one text of the metadata.
Case text(std::string name, const char* key, const char* value, std::string what, std::string fix) {
  return file(
      std::move(name), [=](NetworkFile& f) { f.header["__metadata__"][key] = value; },
      std::string("__metadata__: '") + key + "'", std::move(what), std::move(fix));
}

/// A case whose header is this text, with no data.
Case header(std::string name, std::string text, std::string place, std::string what) {
  return {std::move(name),
          [text = std::move(text)] { return test::littleEndian(text.size(), 8) + text; },
          std::move(place), std::move(what), "export the network again"};
}

/// A case that moves a tensor's range.
Case offsets(std::string name, const char* tensor, std::size_t begin, std::size_t end,
             std::string what) {
  return file(
      std::move(name),
      [=](NetworkFile& f) {
        f.header[tensor]["data_offsets"] = {begin, end};
      },
      std::string("tensor '") + tensor + "'", std::move(what));
}

/// A case that puts other bits in place of a value of a tensor.
Case value(std::string name, std::size_t at, float number, std::string place) {
  return file(
      std::move(name),
      [=](NetworkFile& f) {
        f.data.replace(at, 4, test::littleEndian(std::bit_cast<std::uint32_t>(number), 4));
      },
      std::move(place), "is not finite", "train again");
}

std::vector<Case> containerCases() {
  const std::string place = "byte 8";
  const auto changed = [](const char* tensor, const char* key, json with) {
    return [=](NetworkFile& f) { f.header[tensor][key] = with; };
  };
  const std::string weight = "tensor 'layer0.weight'";
  return {
      {"TooShort", [] { return std::string("abc"); }, "byte 0", "has 3 bytes, too few",
       "export the network again"},
      {"HeaderLongerThanFile", [] { return test::littleEndian(100, 8) + "{}"; }, "byte 0",
       "said to have 100 bytes, 2 follow", "export the network again"},
      {"HeaderLengthOverflows", [] { return std::string(8, '\xFF') + "{}"; }, "byte 0",
       "said to have 18446744073709551615 bytes", "export the network again"},
      {"HeaderTooLong", [] { return test::littleEndian(65537, 8) + "{" + std::string(65536, ' '); },
       "byte 0", "has 65537 bytes, the limit is 65536", "shorten its texts"},
      header("HeaderEmpty", "", place, "no JSON object begins here"),
      header("HeaderBeginsWithBlank", " {}", place, "no JSON object begins here"),
      header("HeaderNotJson", "{\"a\":}", "byte 13", "is no JSON"),
      header("HeaderPaddedWithNul", std::string("{}\0", 3), "byte 10", "is no JSON"),
      header("HeaderTooDeep", R"({"a":{"b":[[1]]}})", "header", "nested too deep"),
      header("HeaderNumberTooLarge", R"({"a":{"shape":[1e999]}})", "header", "too large"),
      header("TensorTwice", R"({"layer0.bias":{},"layer0.bias":{}})", "header",
             "'layer0.bias' stands there twice"),
      header("FieldTwice", R"({"a":{"dtype":"F32","dtype":"F16"}})", "header",
             "'dtype' stands there twice"),
      header("TensorNoObject", R"({"a":3})", "tensor 'a'", "is no object"),
      header("MetadataNoObject", R"({"__metadata__":3})", "__metadata__", "is no object"),
      file(
          "MetadataNoText", [](NetworkFile& f) { f.header["__metadata__"]["version"] = 1; },
          "__metadata__: 'version'", "is 1", "give a text in quotes"),
      file("TensorKeyUnknown", changed("layer0.weight", "data_offset", {0, 24}),
           weight + ": 'data_offset'", "is not known", "the nearest is 'data_offsets'"),
      file(
          "TypeMissing", [](NetworkFile& f) { f.header["layer0.weight"].erase("dtype"); }, weight,
          "'dtype' is missing"),
      file("TypeUnknown", changed("layer0.weight", "dtype", "BF16"), weight, "'dtype' is 'BF16'",
           "give one of F16, F32"),
      file(
          "ShapeMissing", [](NetworkFile& f) { f.header["layer0.weight"].erase("shape"); }, weight,
          "'shape' is missing"),
      file("ShapeNegative", changed("layer0.weight", "shape", {-3, 2}), weight, "'shape' is -3",
           "give a whole number >= 0"),
      file("ShapeNoList", changed("layer0.weight", "shape", 6), weight, "'shape' is 6",
           "give a list of at least one whole number >= 0"),
      // 4 bytes times 2^62 + 6 wraps around to 24.
      file("ShapeOverflows", changed("layer0.weight", "shape", {(std::uint64_t{1} << 62U) + 6, 1}),
           weight, "has 24 bytes, which its shape does not fill"),
      file("ShapeLargerThanRange", changed("layer0.weight", "shape", {3, 3}), weight,
           "has 24 bytes, which its shape does not fill"),
      file("OffsetsNotTwo", changed("layer0.weight", "data_offsets", {0}), weight,
           "'data_offsets' is no beginning and end"),
      offsets("OffsetsBackward", "layer0.weight", 24, 0, "'data_offsets' is no beginning and end"),
      // The tensors lie at 0, 24, 36 and 60; the data end at 68.
      offsets("OffsetsOverlap", "layer1.bias", 56, 64,
              "begins at byte 56 of the data, the tensor before it ends at 60 (they overlap)"),
      file(
          "OffsetsGap",
          [](NetworkFile& f) {
            f.header["layer1.bias"]["data_offsets"] = {64, 72};
            f.data += std::string(4, '\0');
          },
          "tensor 'layer1.bias'",
          "begins at byte 64 of the data, the tensor before it ends at 60 (a gap)"),
      file(
          "OffsetsGapAtBeginning",
          [](NetworkFile& f) {
            for (auto& [key, tensor] : f.header.items()) {
              if (!tensor.contains("data_offsets")) continue;
              for (json& offset : tensor["data_offsets"]) offset = offset.get<int>() + 4;
            }
            f.data.insert(0, 4, '\0');
          },
          weight, "begins at byte 4 of the data, the tensor before it ends at 0 (a gap)"),
      offsets("OffsetsOverTheEnd", "layer1.bias", 64, 72,
              "ends at byte 72 of the data, which has 68"),
      file(
          "CutShort", [](NetworkFile& f) { f.data.pop_back(); }, "tensor 'layer1.bias'",
          "ends at byte 68 of the data, which has 67"),
      file(
          "BytesLeftOver", [](NetworkFile& f) { f.data += "rest"; }, "net.safetensors",
          "4 bytes are left over"),
  };
}

std::vector<Case> metadataCases() {
  std::vector<Case> cases = {
      file(
          "NoMetadata", [](NetworkFile& f) { f.header.erase("__metadata__"); },
          "__metadata__: 'format'", "is missing"),
      text("NotANetwork", "format", "pt", "is 'pt' and not 'macula-network'",
           "name the file of a network made for Macula"),
      text("VersionUnknown", "version", "2", "is '2' and not '1'", "export the network for it"),
      text("ActivationUnknown", "activation", "gelu", "is 'gelu' and not 'relu'",
           "train the hidden layers with it"),
      text("OutputActivationUnknown", "output_activation", "tanh", "is 'tanh'",
           "give one of none, sigmoid"),
      text("ModelEmpty", "model", "", "is ''", "give a text in quotes (a name)"),
      text("FeatureEmpty", "features", "depth,", "holds the name ''", "by commas alone"),
      text("FeatureWithBlank", "features", "depth, normal", "holds the name ' normal'",
           "by commas alone"),
      text("FeatureTwice", "features", "depth,depth", "holds 'depth' twice", "name each once"),
      text("OutputTwice", "outputs", "near,near", "holds 'near' twice", "name each once"),
      text("MeanTooFew", "mean", "1", "holds 1 number for 2 features", "write one a feature"),
      text("MeanTooMany", "mean", "1 2 3", "holds 3 numbers for 2 features", "write one a feature"),
      text("MeanNoNumber", "mean", "1 two", "holds 'two', which is no number",
           "write decimal numbers"),
      text("MeanTrailing", "mean", "1 2x", "holds '2x', which is no number",
           "write decimal numbers"),
      text("MeanNan", "mean", "1 nan", "holds 'nan', which is no finite float", "training data"),
      text("MeanTooLarge", "mean", "1 1e39", "holds '1e39', which is no finite float",
           "training data"),
      text("ScaleTooFew", "scale", "1", "holds 1 number for 2 features", "write one a feature"),
      text("ScaleInfinite", "scale", "1 inf", "holds 'inf', which is no finite float",
           "training data"),
      text("ScaleOutOfRange", "scale", "1 1e999", "holds '1e999', which is no finite float",
           "training data"),
      text("ScaleZero", "scale", "1 0", "is 0 for 'normal'", "leave a feature out"),
      text("ScaleTooSmall", "scale", "1e-60 1", "is 0 for 'depth'", "leave a feature out"),
      text("DataShort", "data", "abc", "is 'abc' and no SHA-256", "export the network again"),
      file(
          "DataNoHash",
          [](NetworkFile& f) { f.header["__metadata__"]["data"] = std::string(64, 'g'); },
          "__metadata__: 'data'", "and no SHA-256"),
  };
  for (const char* key : {"format", "version", "model", "features", "outputs", "mean", "scale",
                          "activation", "output_activation", "command", "data"}) {
    cases.push_back(file(
        std::string("Missing_") + key, [=](NetworkFile& f) { f.header["__metadata__"].erase(key); },
        std::string("__metadata__: '") + key + "'", "is missing"));
  }
  return cases;
}

std::vector<Case> layerCases() {
  const auto reshaped = [](const char* tensor, const json& shape) {
    return [=](NetworkFile& f) { f.header[tensor]["shape"] = shape; };
  };
  const auto renamed = [](const char* from, const char* to) {
    return [=](NetworkFile& f) {
      f.header[to] = f.header[from];
      f.header.erase(from);
    };
  };
  return {
      file(
          "NoTensor",
          [](NetworkFile& f) {
            f.header = {{"__metadata__", f.header["__metadata__"]}};
            f.data.clear();
          },
          "tensor 'layer0.weight'", "is missing"),
      file("BiasMissing", renamed("layer1.bias", "layer1.offset"), "tensor 'layer1.offset'",
           "belongs to no layer", "name them layer0.weight, layer0.bias"),
      file(
          "WeightMissing",
          [](NetworkFile& f) {
            f.header.erase("layer1.weight");
            f.header["layer1.bias"]["data_offsets"] = {36, 44};
            f.data.erase(36, 24);
          },
          "tensor 'layer1.weight'", "is missing"),
      file(
          "LayerLeftOut",
          [=](NetworkFile& f) {
            renamed("layer1.weight", "layer2.weight")(f);
            renamed("layer1.bias", "layer2.bias")(f);
          },
          "tensor 'layer2.bias'", "belongs to no layer", "name them layer0.weight, layer0.bias"),
      file("WeightOfOneDimension", reshaped("layer0.weight", {6}), "tensor 'layer0.weight'",
           "has 1 dimension, not 2"),
      file("BiasOfTwoDimensions", reshaped("layer0.bias", {3, 1}), "tensor 'layer0.bias'",
           "has 2 dimensions, not 1"),
      file("FeaturesDisagree", reshaped("layer0.weight", {2, 3}), "tensor 'layer0.weight'",
           "takes 3 inputs, the number of features is 2"),
      file("LayersDisagree", reshaped("layer1.weight", {3, 2}), "tensor 'layer1.weight'",
           "takes 2 inputs, the layer before gives 3"),
      file(
          "BiasDisagrees",
          [](NetworkFile& f) {
            f.header["layer1.bias"]["shape"] = {3};
            f.header["layer1.bias"]["data_offsets"] = {60, 72};
            f.data += std::string(4, '\0');
          },
          "tensor 'layer1.bias'", "has 3 values for 2 outputs"),
      file(
          "OutputsDisagree", [](NetworkFile& f) { f.header["__metadata__"]["outputs"] = "near"; },
          "tensor 'layer1.weight'", "gives 2 outputs, __metadata__ names 1"),
      file(
          "LayerWithoutInputs",
          [](NetworkFile& f) {
            f.header = {{"__metadata__", f.header["__metadata__"]}};
            f.data.clear();
            f.addF32("layer0.weight", {2, 0}, {});
            f.addF32("layer0.bias", {2}, {0, 0});
          },
          "tensor 'layer0.weight'", "takes 0 inputs, the number of features is 2"),
      file(
          "LayerWithoutOutputs",
          [](NetworkFile& f) {
            f.header = {{"__metadata__", f.header["__metadata__"]}};
            f.data.clear();
            f.addF32("layer0.weight", {0, 2}, {});
            f.addF32("layer0.bias", {0}, {});
          },
          "tensor 'layer0.weight'", "has 0 outputs, not 1 to 256", "train another network"),
      value("WeightNan", 4, std::nanf(""), "tensor 'layer0.weight': value 1"),
      value("BiasInfinite", 64, -INFINITY, "tensor 'layer1.bias': value 1"),
      file(
          "HalfInfinite",
          [](NetworkFile& f) {
            f.header = {{"__metadata__", f.header["__metadata__"]}};
            f.data.clear();
            f.addF16("layer0.weight", {2, 2}, {0, 0, 0, 0x7C00});
            f.addF16("layer0.bias", {2}, {0, 0});
          },
          "tensor 'layer0.weight': value 3", "is not finite", "train again"),
  };
}

class NetworkErrors : public testing::TestWithParam<Case> {};

TEST_P(NetworkErrors, NameFilePlaceAndMend) {
  const Case& spoilt = GetParam();
  std::string message = "no error";
  try {
    static_cast<void>(test::parse(spoilt.bytes()));
  } catch (const InputError& error) {
    message = error.what();
  }
  EXPECT_THAT(message, StartsWith("net.safetensors: "));
  EXPECT_THAT(message, HasSubstr(spoilt.place));
  EXPECT_THAT(message, HasSubstr(spoilt.what));
  EXPECT_THAT(message, HasSubstr(spoilt.fix));
}

std::string nameOf(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Container, NetworkErrors, testing::ValuesIn(containerCases()), nameOf);
INSTANTIATE_TEST_SUITE_P(Metadata, NetworkErrors, testing::ValuesIn(metadataCases()), nameOf);
INSTANTIATE_TEST_SUITE_P(Layers, NetworkErrors, testing::ValuesIn(layerCases()), nameOf);

}  // namespace
}  // namespace macula::network
