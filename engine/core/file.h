// Whole files in and out. A reader never sees a file that is half written.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace macula {

/// Reads a whole file.
/// @throws InputError naming the path where it is missing, a folder or unreadable.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& path);

/// Writes to `path` + ".part" beside it, then renames, so that an interrupted run leaves either the
/// old file or the new one.
/// @throws InputError naming the path where the folder cannot be written.
void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// The same for writers that want a path of their own (an image library): calls `write` with the
/// temporary path, then renames it to `path`. The temporary keeps the extension of `path`.
void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(const std::filesystem::path&)>& write);

/// Makes a folder and its parents and checks that files can be made in it.
/// @throws InputError naming the folder and the reason.
void makeOutputFolder(const std::filesystem::path& folder);

/// A folder that ships with the program ("shaders", "assets"): from $MACULA_DATA if set, beside the
/// installed program (../share/macula), or in the source tree it was built from; in that order.
/// @throws InputError where none of these holds it.
[[nodiscard]] std::filesystem::path dataFolder(std::string_view name);

/// A part of the program that is loaded when it is first needed: from $MACULA_MODULES if set, and
/// from there only; otherwise beside the program (a build) or in ../lib/macula (an installation).
/// @param file its file name
/// @throws InputError naming the path where it is missing.
[[nodiscard]] std::filesystem::path moduleFile(std::string_view file);

}  // namespace macula
