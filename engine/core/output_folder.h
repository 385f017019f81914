// The folder that a subcommand writes into: whose it is, and what of an earlier run goes.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace macula {

/// In each output folder: "macula SUBCOMMAND", then a line for each file that the next run of the
/// subcommand replaces. Written before the files themselves, so that what a killed run left behind
/// is known, too.
inline constexpr const char* kOutputManifest = "macula-output.txt";

class OutputFolder {
 public:
  /// Takes a folder that is missing, empty, or holds what the same subcommand wrote, by its
  /// manifest or, from versions without one, by its report. Makes the folder, and changes nothing
  /// in it until begin().
  /// @param subcommand "replay" @param force takes any other folder as well
  /// @throws InputError where it holds something else or cannot be written
  OutputFolder(std::filesystem::path folder, std::string subcommand, bool force);

  /// Removes the files that the manifest of an earlier run of this subcommand names, and nothing
  /// else, and begins a new manifest. To be called before other files than those of file().
  void begin();

  /// FOLDER/NAME for a file that the next run replaces; noted in the manifest. The first call
  /// begins, so that what was there outlives a run that fails before it has something to write.
  /// @param name without folders
  [[nodiscard]] std::filesystem::path file(const std::string& name);

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

 private:
  void removeEarlier() const;

  std::filesystem::path folder_;
  std::string subcommand_;
  std::ofstream manifest_;
};

}  // namespace macula
