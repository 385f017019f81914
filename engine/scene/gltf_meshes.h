// Meshes of a glTF file as primitives: specification section 3.7.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/scene/gltf_document.h"
#include "engine/scene/gltf_loader.h"
#include "engine/scene/gltf_nodes.h"
#include "engine/scene/gltf_skins.h"

namespace macula::scene::gltf {

/// Builds primitives on demand, each mesh once, however many nodes draw it; a skinned mesh once for
/// each skin, in world space.
class MeshReader {
 public:
  /// References are kept. scene.materials must be filled.
  MeshReader(Document& document, const NodeTree& tree, const GltfLimits& limits, Scene& scene)
      : document_(document), tree_(tree), limits_(limits), scene_(scene) {}

  struct Range {
    std::uint32_t first = 0;  ///< index into Scene::primitives
    std::uint32_t count = 0;
  };
  /// The primitives of a mesh; read where this is its first use.
  /// @param skin kNone, or a skin: then they are in world space already
  /// @throws InputError on malformed meshes and beyond the limits
  [[nodiscard]] Range read(std::int32_t mesh, std::int32_t skin);

  /// Whether a node with this mesh and skin is drawn by joints; where its vertices name none, it
  /// is drawn by the node's own transform.
  [[nodiscard]] bool isSkinned(std::int32_t mesh, std::int32_t skin) const;

 private:
  void readPrimitive(const tinygltf::Primitive& source, std::int32_t skin);
  [[nodiscard]] std::size_t vertexCount(const tinygltf::Primitive& source, std::int32_t position);
  [[nodiscard]] Elements attribute(const tinygltf::Primitive& source, const std::string& semantic,
                                   std::size_t least, std::size_t most,
                                   Integers integers = Integers::AsDeclared);
  void readAttributes(const tinygltf::Primitive& source, Primitive& primitive);
  void readIndexList(const tinygltf::Primitive& source, Primitive& primitive);
  void applyPose(const tinygltf::Primitive& source, std::int32_t skin, Primitive& primitive);
  void dropUnusable(Primitive& primitive);
  void completeAttributes(const tinygltf::Primitive& source, Primitive& primitive);
  void countVertices(std::uint64_t vertices);
  void countIndices(std::uint64_t indices);

  Document& document_;
  const NodeTree& tree_;
  const GltfLimits& limits_;
  Scene& scene_;
  std::map<std::pair<std::int32_t, std::int32_t>, Range> ranges_;
  std::map<std::int32_t, SkinPose> poses_;
  std::string place_;           // "mesh 3 primitive 0", for messages
  std::size_t count_ = 0;       // vertices of the primitive being read
  std::uint64_t vertices_ = 0;  // read so far
  std::uint64_t indices_ = 0;
};

}  // namespace macula::scene::gltf
