// glTF 2.0 files into plain scenes (Khronos: The glTF 2.0 Specification, version 2.0.1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene {

/// Limits of one file, so that a few malformed bytes cannot exhaust the memory. The defaults are
/// far above real scenes.
struct GltfLimits {
  std::uint64_t vertices = std::uint64_t{1} << 26U;    ///< over all primitives; 72 bytes each
  std::uint64_t indices = std::uint64_t{3} << 26U;     ///< over all primitives; 4 bytes each
  std::uint64_t instances = std::uint64_t{1} << 22U;   ///< over all nodes
  int imageSide = 16384;                               ///< pixels; the texture limit of common GPUs
  std::uint64_t imageBytes = std::uint64_t{4} << 30U;  ///< decoded, over all images
};

/// Loads a .gltf or .glb file; the content decides which, not the name.
///
/// Drawn: triangles (lists, strips, fans), node hierarchy, perspective cameras, metallic-roughness
/// materials, KHR_lights_punctual, KHR_materials_unlit, _transmission, _volume,
/// _emissive_strength, KHR_mesh_quantization. Skins stand in the pose of the file's nodes, morph
/// targets in their base shape. Images, in the order of the file, are PNG or JPEG; one that cannot
/// be decoded or that no material reads is a single white pixel, so that Scene::images keeps the
/// file's numbering. Everything left out is one line in Scene::warnings. No light is added.
/// @throws InputError naming the file, the place in it and the fix, where it is missing or
///   malformed, or requires an extension that is not drawn
[[nodiscard]] Scene loadGltf(const std::filesystem::path& file, const GltfLimits& limits = {});

/// The same from the bytes of a .gltf or .glb file.
/// @param baseFolder where relative URIs lead; empty: a file that needs other files is an error
/// @param displayName names the file in messages, and the scene
[[nodiscard]] Scene loadGltfFromMemory(std::span<const std::byte> bytes,
                                       const std::filesystem::path& baseFolder,
                                       const std::string& displayName,
                                       const GltfLimits& limits = {});

/// The files that a .gltf or .glb names beside itself: its buffers, then its images, each once, in
/// the order of the file. Data inside the file does not count.
/// @return paths relative to the file's folder, as it writes them but for percent-encoding; none
///   where the file is no glTF
/// @throws InputError where the file cannot be read
[[nodiscard]] std::vector<std::filesystem::path> referencedFiles(const std::filesystem::path& file);

}  // namespace macula::scene
