// The binary part of a .glb file while it is written, with the JSON that describes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene {

/// Keeps members in the order in which they are written.
using GlbJson = nlohmann::ordered_json;

/// Collects bytes, bufferViews and accessors.
class GlbBuffer {
 public:
  /// Appends the vertices and indices of a primitive; returns its entry for `meshes[].primitives`.
  /// @param primitive not empty
  /// @param withTangents writes TANGENT
  /// @param withUv writes TEXCOORD_0 and, where used, TEXCOORD_1
  [[nodiscard]] GlbJson addPrimitive(const Primitive& primitive, bool withTangents, bool withUv);

  /// Appends an image as PNG; returns its entry for `images`.
  [[nodiscard]] GlbJson addImage(const Image& image);

  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] const GlbJson& views() const { return views_; }
  [[nodiscard]] const GlbJson& accessors() const { return accessors_; }

 private:
  std::size_t addView(std::span<const std::byte> bytes, int target);
  std::size_t addFloats(const std::vector<float>& values, int components);
  std::size_t addIndices(const Primitive& primitive);

  std::string bytes_;
  GlbJson views_ = GlbJson::array();
  GlbJson accessors_ = GlbJson::array();
};

/// The PNG file of an image (RGB where every pixel is opaque, else RGBA).
[[nodiscard]] std::vector<std::byte> pngBytes(const Image& image);

}  // namespace macula::scene
