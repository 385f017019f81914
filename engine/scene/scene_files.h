// The files that a scene is made of.
#pragma once

#include <filesystem>
#include <vector>

namespace macula::scene {

/// The files that a .gltf or .glb names beside itself: its buffers, then its images, each once, in
/// the order of the file. Data inside the file does not count.
/// @return paths relative to the file's folder, as it writes them but for percent-encoding; none
///   where the file is no glTF
/// @throws InputError where the file cannot be read
[[nodiscard]] std::vector<std::filesystem::path> referencedFiles(const std::filesystem::path& file);

}  // namespace macula::scene
