// The binary part of a .glb file while it is written, with what describes it.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene {

/// Collects bytes, bufferViews, accessors and images in a model with at most one buffer.
class GlbBuffer {
 public:
  /// @param model must outlive this
  explicit GlbBuffer(tinygltf::Model& model) : model_(model) {}

  /// Appends the vertices and indices of a primitive; returns its entry for Mesh::primitives.
  /// @param primitive not empty
  /// @param withTangents writes TANGENT
  /// @param withUv writes TEXCOORD_0 and, where used, TEXCOORD_1
  [[nodiscard]] tinygltf::Primitive addPrimitive(const Primitive& primitive, bool withTangents,
                                                 bool withUv);

  /// Appends an image as PNG.
  void addImage(const Image& image);

 private:
  int addView(std::span<const std::byte> bytes, int target);
  int addAccessor(int view, int componentType, int type, std::size_t count);
  int addFloats(const std::vector<float>& values, int components);
  int addIndices(const Primitive& primitive);

  tinygltf::Model& model_;
};

/// The PNG file of an image (RGB where every pixel is opaque, else RGBA).
[[nodiscard]] std::vector<std::byte> pngBytes(const Image& image);

/// A name as JSON can hold it: what is no UTF-8 is replaced.
[[nodiscard]] std::string validName(const std::string& name);

}  // namespace macula::scene
