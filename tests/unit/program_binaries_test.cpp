// Where linked programs are kept. No GL.
#include "engine/gl/program_binaries.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>

namespace macula::gl {
namespace {

/// Variables of the environment as the test sets them, and as they were afterwards.
class ProgramFolder : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"MACULA_SHADER_CACHE", "XDG_CACHE_HOME", "HOME"}) {
      if (const char* value = std::getenv(name)) before_[name] = value;
      unsetenv(name);
    }
  }
  void TearDown() override {
    for (const char* name : {"MACULA_SHADER_CACHE", "XDG_CACHE_HOME", "HOME"}) unsetenv(name);
    for (const auto& [name, value] : before_) setenv(name.c_str(), value.c_str(), 1);
  }

 private:
  std::map<std::string, std::string> before_;
};

TEST_F(ProgramFolder, IsTheUsersCache) {
  EXPECT_FALSE(programBinaryFolder().has_value());
  setenv("HOME", "/home/a", 1);
  EXPECT_EQ(programBinaryFolder(), "/home/a/.cache/macula/shaders");
  setenv("XDG_CACHE_HOME", "relative", 1);
  EXPECT_EQ(programBinaryFolder(), "/home/a/.cache/macula/shaders");
  setenv("XDG_CACHE_HOME", "/cache", 1);
  EXPECT_EQ(programBinaryFolder(), "/cache/macula/shaders");
}

TEST_F(ProgramFolder, CanBeChosenOrSwitchedOff) {
  setenv("HOME", "/home/a", 1);
  setenv("MACULA_SHADER_CACHE", "/elsewhere", 1);
  EXPECT_EQ(programBinaryFolder(), "/elsewhere");
  setenv("MACULA_SHADER_CACHE", "off", 1);
  EXPECT_FALSE(programBinaryFolder().has_value());
  setenv("MACULA_SHADER_CACHE", "", 1);
  EXPECT_EQ(programBinaryFolder(), "/home/a/.cache/macula/shaders");
}

}  // namespace
}  // namespace macula::gl
