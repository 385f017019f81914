// A copy of the shaders in which a test changes something.
#pragma once

#include <filesystem>
#include <string>

namespace macula::test {

/// In a temporary folder, for as long as it lives.
class ShaderCopy {
 public:
  ShaderCopy();
  ~ShaderCopy();
  ShaderCopy(const ShaderCopy&) = delete;
  ShaderCopy& operator=(const ShaderCopy&) = delete;
  /// Sets what a line of shared/oit_constants.h defines; that it is there is expected.
  void define(const std::string& name, const std::string& value) const;
  /// Adds a file of tests/gl.
  void add(const std::string& name) const;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace macula::test
