// Linked programs as the driver's own binaries, kept in a folder of the user from run to run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gl/gl.h"

namespace macula::gl {

/// Where binaries are kept: $MACULA_SHADER_CACHE, which `off` switches off, or else macula/shaders
/// in $XDG_CACHE_HOME, or in ~/.cache. None where it is off or no folder is known.
[[nodiscard]] std::optional<std::filesystem::path> programBinaryFolder();

/// Never fails: what is missing, damaged, of another driver or cannot be written is as if it were
/// not there. Several processes may use one folder.
class ProgramBinaries {
 public:
  /// Room for 2,600 programs of the 25 KB that they take on Mesa: several versions and drivers.
  static constexpr std::uint64_t kMostBytes = 64U << 20U;

  /// Keeps nothing.
  ProgramBinaries() = default;
  /// For the current context; keeps nothing where its driver has no binaries.
  /// @param mostBytes files of the folder may hold; those used least recently go first
  explicit ProgramBinaries(std::filesystem::path folder, std::uint64_t mostBytes = kMostBytes);

  [[nodiscard]] bool active() const { return !formats_.empty(); }
  /// Name of a program's file, by driver and source. @param source all that the program is made of
  [[nodiscard]] std::string nameOf(std::string_view source) const;
  /// Makes a program from its file. @returns whether it is linked now
  bool load(GLuint program, const std::string& name);
  /// Writes a linked program, which was made with GL_PROGRAM_BINARY_RETRIEVABLE_HINT.
  void store(GLuint program, const std::string& name);
  /// Removes files until the folder keeps to its bound. After a number of store().
  void trim();

  struct Counts {
    std::size_t loaded = 0;
    std::size_t refused = 0;  ///< files that were damaged or that the driver did not take
    std::size_t stored = 0;
    std::size_t lost = 0;  ///< could not be written
  };
  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  std::filesystem::path folder_;
  std::uint64_t mostBytes_ = 0;
  std::string driver_;
  std::vector<GLenum> formats_;
  Counts counts_;
  bool writable_ = true;  ///< until a file could not be written
};

}  // namespace macula::gl
