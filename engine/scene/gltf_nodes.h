// The node hierarchy of a glTF file, its lights and its cameras: specification section 3.5.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/scene/gltf_document.h"

namespace macula::scene::gltf {

struct NodeTree {
  std::vector<glm::mat4> world;     ///< node to world, for every node of the file
  std::vector<std::int32_t> drawn;  ///< nodes of the chosen scene, parents before children
};

/// Places all nodes and chooses the scene: the default one, else the first, else all root nodes.
/// @throws InputError on a child that does not exist, has two parents or is its own ancestor, and
///   on transforms that are malformed or beyond kMaxCoordinate
[[nodiscard]] NodeTree placeNodes(Document& document);

/// Adds the scene's KHR_lights_punctual lights, in world space.
void addLights(Document& document, const NodeTree& tree, Scene& scene);

/// Adds the scene's perspective cameras, in world space. One without a far plane, which glTF draws
/// to infinity, gets a far plane behind everything in `scene`, so call this last.
void addCameras(Document& document, const NodeTree& tree, Scene& scene);

/// Coordinates beyond this count as not finite: their squares must fit into a float.
inline constexpr float kMaxCoordinate = 1e15F;

/// Whether a point or a direction can be computed with.
[[nodiscard]] inline bool isUsable(const glm::vec3& p) {
  return glm::all(glm::lessThanEqual(glm::abs(p), glm::vec3(kMaxCoordinate)));
}

}  // namespace macula::scene::gltf
