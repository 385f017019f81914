// Skins in the pose of the file's nodes: specification section 3.7.3.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "engine/scene/gltf_accessors.h"
#include "engine/scene/gltf_document.h"
#include "engine/scene/gltf_nodes.h"

namespace macula::scene::gltf {

/// World transform of each joint times its inverse bind matrix.
using SkinPose = std::vector<glm::mat4>;

/// The pose of a skin. @throws InputError on joints or matrices that lead nowhere
[[nodiscard]] SkinPose poseOf(const Document& document, const NodeTree& tree, std::int32_t skin);

/// JOINTS_n and WEIGHTS_n of one primitive; four influences a set.
struct Influences {
  std::vector<Elements> joints;
  std::vector<Elements> weights;  ///< as many as joints
};

/// Moves vertices, normals and tangents of an object-space primitive into the world. The winding
/// of triangles whose joints mirror is turned, so that front faces stay in front.
/// @throws InputError where a vertex names a joint that the skin does not have
void applySkin(const Document& document, const SkinPose& pose, const Influences& influences,
               std::string_view place, Primitive& primitive);

}  // namespace macula::scene::gltf
