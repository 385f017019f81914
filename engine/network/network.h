// A small dense network as read from a file, and its evaluation on the CPU, the mirror of the
// compute shader that runs it for every pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace macula::network {

/// Features at most. More than Macula can measure of a pixel.
inline constexpr std::size_t kMaxInputs = 64;
/// Values of a layer at most. A shader keeps two layers' values of a pixel, 2 KiB at this width.
inline constexpr std::size_t kMaxWidth = 256;
/// Layers at most. At 256 values each has 65,536 weights to be read for every pixel.
inline constexpr std::size_t kMaxLayers = 8;
/// Bytes of a file at most: the largest network within the limits above, in F32, is half of this.
inline constexpr std::size_t kMaxFileBytes = std::size_t{4} << 20U;
static_assert(2 * kMaxLayers * kMaxWidth * kMaxWidth * sizeof(float) <= kMaxFileBytes);

/// Activation of the last layer, in the order of their names in metadata.cpp.
enum class OutputActivation : std::uint8_t {
  None,
  Sigmoid,  ///< 1 / (1 + exp(-x)), in 0..1
};

/// y = W x + b.
struct DenseLayer {
  int inputs = 0;
  int outputs = 0;
  std::vector<float>
      weights;              ///< outputs x inputs, row-major: a row holds the weights of one output
  std::vector<float> bias;  ///< one an output
};

/// A network that has been checked: counts agree, every number is finite, no scale is 0.
/// The hidden layers' activation is max(x, 0).
struct Network {
  std::string model;                  ///< a name, for example "macula"
  std::vector<std::string> features;  ///< the inputs' names, in order; none twice
  std::vector<std::string> outputs;   ///< the outputs' names, in order; none twice
  std::vector<float> mean;            ///< one a feature, in its unit
  std::vector<float> scale;           ///< one a feature, in 1 / its unit, not 0
  OutputActivation outputActivation = OutputActivation::None;
  std::vector<DenseLayer> layers;  ///< at least one
  std::string command;             ///< the command that trained it
  std::string dataHash;            ///< SHA-256 of the training data, 64 hexadecimal digits
};

/// Reads a network; the format stands in README.md.
/// @throws InputError naming the file, the place in it and the fix
[[nodiscard]] Network readNetwork(const std::filesystem::path& path);

/// The same from bytes. @param name of the file in messages
[[nodiscard]] Network parseNetwork(std::span<const std::byte> bytes, const std::string& name);

/// The outputs for one pixel. A sum begins with the bias and takes the inputs in order, each
/// rounded to float, so that a shader that does the same gives the same bits but for exp().
/// @param features one for each of `network.features`, in its unit; layer 0 sees
///        (feature - mean) * scale
/// @throws std::invalid_argument where their number is another
[[nodiscard]] std::vector<float> evaluate(const Network& network, std::span<const float> features);

}  // namespace macula::network
