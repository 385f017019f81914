// Files that a walk reads and writes: which a folder holds, and names that are not taken yet.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace macula::tools {

/// Whether a file is a camera path: by its content, which begins with the path's header.
[[nodiscard]] bool isCameraPathFile(const std::filesystem::path& path);

/// The scene files of a folder, by name; none where it cannot be read. At most 1000.
[[nodiscard]] std::vector<std::filesystem::path> sceneFiles(const std::filesystem::path& folder);

/// PREFIX_001.EXTENSION with the least number that no file has, and that is none of `taken`.
[[nodiscard]] std::filesystem::path nextFreeName(const std::string& prefix,
                                                 std::string_view extension,
                                                 const std::set<std::string>& taken = {});

}  // namespace macula::tools
