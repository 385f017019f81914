// Scenes by name: a file, or a recipe that computes one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene {

/// The procedural scene that is shown where none is named.
inline constexpr const char* kDefaultScene = "gallery";

/// A procedural scene for listing.
struct RecipeInfo {
  std::string name;  ///< as loadScene takes it; "layers-N" stands for layers-1, layers-2, ...
  std::string description;  ///< one line
};

/// All procedural scenes.
[[nodiscard]] std::vector<RecipeInfo> recipes();

/// Whether a name ends in .gltf or .glb, in any case.
[[nodiscard]] bool isSceneFile(const std::filesystem::path& path);
/// Whether a name is that of a procedural scene; whether the N of one is in range, loading tells.
[[nodiscard]] bool isProcedural(const std::string& name);
/// Why a name that is neither of these can be no scene, and the cure: the end of a message.
[[nodiscard]] std::string unknownScene(const std::string& nameOrPath);

/// Computes a procedural scene or loads a glTF file.
/// @param nameOrPath a name of recipes() or a path that ends in .gltf or .glb (in any case)
/// @param seed of procedural scenes; files do not use it
/// @throws InputError where it is neither, naming the most similar recipe, and where the file is
///   missing or malformed
[[nodiscard]] Scene loadScene(const std::string& nameOrPath, std::uint64_t seed);

}  // namespace macula::scene
