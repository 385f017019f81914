// Materials of a .glb file while it is written.
#pragma once

#include <tiny_gltf.h>

#include <map>
#include <set>
#include <string>
#include <utility>

#include "engine/scene/scene.h"

namespace macula::scene {

/// Adds materials, textures and samplers to a model; equal pairs of image and sampler share one
/// texture.
class GlbMaterials {
 public:
  /// @param model must outlive this · @param extensions receives the names of those that are used
  GlbMaterials(tinygltf::Model& model, std::set<std::string>& extensions)
      : model_(model), extensions_(extensions) {}

  void add(const Material& source);

 private:
  int samplerIndex(const Sampler& sampler);
  /// Info is one of tinygltf's three kinds of texture reference.
  template <typename Info>
  void setTexture(const TextureRef& ref, Info& info);
  void addExtensions(const Material& source, tinygltf::Material& out);

  tinygltf::Model& model_;
  std::set<std::string>& extensions_;
  std::map<std::pair<int, int>, int> textureOf_;  ///< (image, sampler) to texture
};

/// JSON of a number, and of a colour or direction as an array of three.
[[nodiscard]] tinygltf::Value toValue(float number);
[[nodiscard]] tinygltf::Value toValue(const glm::vec3& v);

}  // namespace macula::scene
