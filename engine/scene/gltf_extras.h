// The extras that Macula writes into files: see glb_writer.h.
#pragma once

#include "engine/scene/gltf_document.h"

namespace macula::scene::gltf {

/// `macula_casts_shadow` of a light; false where it is missing.
[[nodiscard]] bool castsShadow(const tinygltf::Light& light);

/// `macula_shadow_taps` of a light, odd, 1 .. kMostShadowTaps: an even number counts as one more.
/// kUsualShadowTaps where it is missing or no number.
[[nodiscard]] int shadowTaps(const tinygltf::Light& light);

/// `macula_target_distance` of a camera's node in metres; 0 where it is missing or unusable.
[[nodiscard]] float targetDistance(const tinygltf::Node& node);

/// `macula_ambient` of the scene that is drawn, linear RGB >= 0; black where it is missing.
[[nodiscard]] glm::vec3 ambientOf(const Document& document);

/// `macula_occlusion` {radius, samples} of the scene that is drawn, within the limits of scene.h;
/// none where it is missing or unusable.
[[nodiscard]] AmbientOcclusion occlusionOf(const Document& document);

/// `macula_veins` {color, scale} of a material, the colour within 0..1; none where they are missing
/// or unusable.
[[nodiscard]] Veins veinsOf(const tinygltf::Material& material);

}  // namespace macula::scene::gltf
