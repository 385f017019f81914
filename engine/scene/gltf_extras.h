// What Macula's own files say in extras: see glb_writer.h.
#pragma once

#include "engine/scene/gltf_document.h"

namespace macula::scene::gltf {

/// `macula_casts_shadow` of a light; false where it is missing.
[[nodiscard]] bool castsShadow(const tinygltf::Light& light);

/// `macula_target_distance` of a camera's node in metres; 0 where it is missing or unusable.
[[nodiscard]] float targetDistance(const tinygltf::Node& node);

/// `macula_ambient` of the scene that is drawn, linear RGB >= 0; black where it is missing.
[[nodiscard]] glm::vec3 ambientOf(const Document& document);

}  // namespace macula::scene::gltf
