// The binary container of glTF: specification section 4, "GLB File Format Specification".
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace macula::scene::gltf {

/// The two parts of a file; views of its bytes.
struct Container {
  std::string_view json;
  std::span<const std::byte> binary;  ///< the BIN chunk; empty in a .gltf
};

/// Takes a .glb apart, or passes the text of a .gltf on.
/// @param name the file, for messages
/// @throws InputError where the bytes are neither, or a .glb is cut off or malformed
[[nodiscard]] Container splitContainer(std::span<const std::byte> bytes, const std::string& name);

}  // namespace macula::scene::gltf
