// A zip of byte blocks, the same bytes for the same blocks.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace macula::dataset {

struct ZipEntry {
  std::string name;  ///< of the file in the zip
  std::string bytes;
};

/// False where the program was built without libzip (MACULA_DATASET=OFF).
[[nodiscard]] bool zipSupported();

/// Writes the entries in order, deflated, all dated 1980-01-01.
/// @param path to write to @param shownPath the path to name in messages
/// @throws InputError where it cannot be written
void writeZip(const std::filesystem::path& path, const std::filesystem::path& shownPath,
              std::span<const ZipEntry> entries);

}  // namespace macula::dataset
