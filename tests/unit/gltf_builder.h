// Small .glb files made in memory, for tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/scene/gltf_loader.h"

namespace macula::test {

// glTF component types, specification section 3.6.2.2.
inline constexpr int kI8 = 5120;
inline constexpr int kU8 = 5121;
inline constexpr int kI16 = 5122;
inline constexpr int kU16 = 5123;
inline constexpr int kU32 = 5125;
inline constexpr int kF32 = 5126;

/// Collects JSON and binary data.
struct GltfBuilder {
  nlohmann::json root{{"asset", {{"version", "2.0"}}}};
  std::string binary;

  /// Appends values as a buffer view, aligned to 4 bytes. @return its index
  template <typename T>
  int view(const std::vector<T>& values, int stride = 0) {
    binary.resize((binary.size() + 3) / 4 * 4);
    nlohmann::json entry{
        {"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", values.size() * sizeof(T)}};
    if (stride != 0) entry["byteStride"] = stride;
    binary.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    root["bufferViews"].push_back(entry);
    return static_cast<int>(root["bufferViews"].size()) - 1;
  }

  /// Appends an accessor. @return its index
  int accessor(nlohmann::json entry) {
    root["accessors"].push_back(std::move(entry));
    return static_cast<int>(root["accessors"].size()) - 1;
  }

  /// Appends values as a view and an accessor. @return the accessor
  template <typename T>
  int attribute(const std::vector<T>& values, int componentType, const char* type,
                std::size_t count, bool normalized = false) {
    const int bufferView = view(values);
    return accessor({{"bufferView", bufferView},
                     {"componentType", componentType},
                     {"type", type},
                     {"count", count},
                     {"normalized", normalized}});
  }

  /// The unit right triangle (0,0,0) (1,0,0) (0,1,0). @return the accessor of its positions
  int trianglePositions() { return attribute<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, kF32, "VEC3", 3); }

  /// One mesh of one primitive on one node.
  void draw(nlohmann::json primitive) {
    root["meshes"].push_back({{"primitives", {std::move(primitive)}}});
    root["nodes"].push_back({{"mesh", root["meshes"].size() - 1}});
  }

  /// The whole .glb.
  [[nodiscard]] std::string glb() {
    if (!binary.empty()) {
      binary.resize((binary.size() + 3) / 4 * 4);
      root["buffers"] = {{{"byteLength", binary.size()}}};
    }
    std::string json = root.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string chunks = chunk(0x4E4F534A, json);
    if (!binary.empty()) chunks += chunk(0x004E4942, binary);
    return "glTF" + u32(2) + u32(12 + chunks.size()) + chunks;
  }

  [[nodiscard]] scene::Scene load(const scene::GltfLimits& limits = {}) {
    return loadText(glb(), limits);
  }

  /// Loads the bytes of a .gltf or .glb under the name "test".
  static scene::Scene loadText(const std::string& file, const scene::GltfLimits& limits = {}) {
    return scene::loadGltfFromMemory(std::as_bytes(std::span(file)), {}, "test", limits);
  }

  static std::string u32(std::size_t value) {
    const auto word = static_cast<std::uint32_t>(value);
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &word, 4);
    return bytes;
  }
  static std::string chunk(std::uint32_t type, const std::string& data) {
    return u32(data.size()) + u32(type) + data;
  }
};

/// Four corners of the unit square with normals, so that vertices are not split.
struct Square : GltfBuilder {
  Square() {
    attributes["POSITION"] =
        attribute<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, kF32, "VEC3", 4);
    attributes["NORMAL"] = attribute<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, kF32, "VEC3", 4);
  }
  nlohmann::json attributes;
};

/// The message of the InputError that `call` throws; empty where it throws none.
template <typename Call>
std::string errorOf(const Call& call) {
  try {
    static_cast<void>(call());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The same for loading what a builder holds.
inline std::string messageOf(GltfBuilder& builder, const scene::GltfLimits& limits = {}) {
  return errorOf([&] { return builder.load(limits); });
}

/// Whether a warning of the scene contains a text.
inline bool warns(const scene::Scene& scene, const std::string& part) {
  return std::any_of(scene.warnings.begin(), scene.warnings.end(),
                     [&](const std::string& w) { return w.find(part) != std::string::npos; });
}

}  // namespace macula::test

#define EXPECT_SAYS(message, part) EXPECT_NE((message).find(part), std::string::npos) << (message)
