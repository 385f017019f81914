// Linked programs, made from the shader files and cached by file and defines.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gl/objects.h"
#include "engine/gl/shader_source.h"

namespace macula::gl {

/// Which program: files relative to the shader folder, and what is defined for all of them.
struct ProgramKey {
  std::vector<std::string> files;
  Defines defines;
  std::vector<std::string> extensions;
  auto operator<=>(const ProgramKey&) const = default;
};

/// Compiles and links on first use. Lives as long as the context.
class ProgramCache {
 public:
  explicit ProgramCache(std::filesystem::path shaderFolder);
  /// @returns the GL name of the program
  /// @throws std::runtime_error with the compiler's messages (a mistake in Macula or the driver)
  GLuint get(const ProgramKey& key);
  /// From now on, programs that get() returns are also noted here; nullptr ends it.
  void record(std::vector<GLuint>* into) { record_ = into; }

 private:
  GLuint make(const ProgramKey& key);

  std::vector<GLuint>* record_ = nullptr;
  std::filesystem::path folder_;
  std::map<ProgramKey, ProgramId> programs_;
};

}  // namespace macula::gl
