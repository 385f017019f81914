// Files of networks, made in memory.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "engine/network/network.h"

namespace macula::network::test {

/// The lowest bytes of a number, little endian.
inline std::string littleEndian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>((value >> (8 * i)) & 0xFFU);
  return text;
}

/// A file in two parts, to be damaged at will.
struct NetworkFile {
  nlohmann::json header;
  std::string data;

  void addF32(const std::string& name, const std::vector<std::size_t>& shape,
              const std::vector<float>& values) {
    const std::size_t begin = data.size();
    for (const float value : values) data += littleEndian(std::bit_cast<std::uint32_t>(value), 4);
    header[name] = {{"dtype", "F32"}, {"shape", shape}, {"data_offsets", {begin, data.size()}}};
  }
  void addF16(const std::string& name, const std::vector<std::size_t>& shape,
              const std::vector<std::uint16_t>& halves) {
    const std::size_t begin = data.size();
    for (const std::uint16_t half : halves) data += littleEndian(half, 2);
    header[name] = {{"dtype", "F16"}, {"shape", shape}, {"data_offsets", {begin, data.size()}}};
  }
  [[nodiscard]] std::string bytes() const {
    const std::string text = header.dump();
    return littleEndian(text.size(), 8) + text + data;
  }
};

inline nlohmann::json metadataOf(const std::string& features, const std::string& outputs,
                                 const std::string& mean, const std::string& scale) {
  return {{"format", "macula-network"},
          {"version", "1"},
          {"model", "thesis"},
          {"features", features},
          {"outputs", outputs},
          {"mean", mean},
          {"scale", scale},
          {"activation", "relu"},
          {"output_activation", "none"},
          {"command", "train.py --seed 1"},
          {"data", std::string(64, 'a')}};
}

/// Two features, three hidden values, two outputs.
inline NetworkFile smallFile() {
  NetworkFile file;
  file.header["__metadata__"] = metadataOf("depth,normal", "near,far", "1 -2", "0.5 2");
  file.addF32("layer0.weight", {3, 2}, {1, 2, -1, -3, 0.5F, 0.25F});
  file.addF32("layer0.bias", {3}, {0.5F, 1, 1});
  file.addF32("layer1.weight", {2, 3}, {2, 5, -4, 1, 1, 1});
  file.addF32("layer1.bias", {2}, {0, -3.25F});
  return file;
}

inline Network parse(const std::string& bytes) {
  return parseNetwork(std::as_bytes(std::span(bytes.data(), bytes.size())), "net.safetensors");
}

}  // namespace macula::network::test
