#include "shader_copy.h"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/core/file.h"

namespace macula::test {
namespace fs = std::filesystem;

ShaderCopy::ShaderCopy()
    : folder_(fs::temp_directory_path() /
              ("macula_shaders_" + std::to_string(fs::hash_value(fs::current_path())) + "_" +
               testing::UnitTest::GetInstance()->current_test_info()->name())) {
  fs::remove_all(folder_);
  fs::copy(dataFolder("shaders"), folder_, fs::copy_options::recursive);
}

ShaderCopy::~ShaderCopy() {
  fs::remove_all(folder_);
}

void ShaderCopy::define(const std::string& name, const std::string& value) const {
  const fs::path header = folder_ / "shared" / "oit_constants.h";
  std::string text = readTextFile(header);
  const std::string line = "#define " + name + " ";
  const std::size_t at = text.find(line);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, text.find('\n', at) - at, line + value);
  fs::permissions(header, fs::perms::owner_write, fs::perm_options::add);
  std::ofstream(header) << text;
}

void ShaderCopy::add(const std::string& name) const {
  fs::copy_file(fs::path(MACULA_SOURCE_DIR) / "tests" / "gl" / name, folder_ / name);
}

}  // namespace macula::test
