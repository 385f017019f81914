// Scenes as binary glTF 2.0 files (Khronos: The glTF 2.0 Specification, version 2.0.1).
#pragma once

#include <filesystem>
#include <string>

#include "engine/scene/scene.h"

namespace macula::scene {

/// The bytes of a .glb file. Reading them with loadGltf gives the same triangles, materials,
/// transforms, lights and cameras; vertex colours beyond 0..1 are clamped, as
/// the specification asks. Equal scenes give equal bytes.
///
/// One mesh for each primitive that is placed, so that instances share it; images are PNG. Tangents
/// are written where the material has a normal texture. Extensions, only where used:
/// KHR_lights_punctual, KHR_materials_unlit, _transmission, _volume, _emissive_strength. Properties
/// that glTF lacks are written as extras where they differ from the default: `macula_ambient`
/// (linear RGB) and `macula_occlusion` {radius (metres), samples} of the scene;
/// `macula_casts_shadow` and `macula_shadow_taps` (a side) of lights; `macula_veins` {color (linear
/// RGB), scale (veins a metre)} of materials; `macula_target_distance` (metres) of camera nodes.
/// @throws InputError where the file would pass 4 GiB, the format's limit
[[nodiscard]] std::string glbBytes(const Scene& scene);

/// Writes glbBytes to a file, all of it or nothing.
/// @throws InputError where the file cannot be written
void writeGlb(const Scene& scene, const std::filesystem::path& file);

}  // namespace macula::scene
