// The container: named tensors and a table of texts. Format: the README of Hugging Face's
// safetensors. Its rules are checked: no key twice, none that the format lacks, and every byte
// belongs to exactly one tensor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace macula::network {

/// The types of the format that Macula reads, in the order of their names in safetensors.cpp.
enum class ScalarType : std::uint8_t { F16, F32 };

struct Tensor {
  ScalarType type = ScalarType::F32;
  std::vector<std::size_t> shape;    ///< outermost first
  std::span<const std::byte> bytes;  ///< of the file: little endian, packed, as many as shape says
};

struct Container {
  nlohmann::json metadata = nlohmann::json::object();  ///< `__metadata__`
  std::map<std::string, Tensor> tensors;
};

/// The fix that most messages end with: nobody repairs such a file by hand.
inline constexpr const char* kExportAgain = "export the network again";

/// @param bytes the whole file; they must outlive the result @param name of the file in messages
/// @throws InputError naming file, place and fix
[[nodiscard]] Container parseSafetensors(std::span<const std::byte> bytes, const std::string& name);

/// The values of a tensor, in its order. They may be infinite or NaN.
[[nodiscard]] std::vector<float> valuesOf(const Tensor& tensor);

}  // namespace macula::network
