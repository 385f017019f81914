// Which file a scene came from, and whether it is still the same.
#pragma once

#include <filesystem>
#include <string>

#include "engine/recording/recording.h"

namespace macula::recording {

/// @param nameOrPath as scene::loadScene() takes it; a file is read whole. Files that a .gltf file
///   refers to are not looked at.
/// @throws InputError where the file cannot be read
[[nodiscard]] SceneSource sourceOf(const std::string& nameOrPath);

/// What to load for a recorded scene: its file, or its procedural name.
/// @throws InputError as checkFile()
[[nodiscard]] std::string checkedScene(const SceneSource& scene);

/// @throws InputError where the file is missing or its SHA-256 is another
void checkFile(const std::filesystem::path& file, const std::string& sha256);

}  // namespace macula::recording
