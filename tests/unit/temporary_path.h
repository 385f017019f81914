// Names of temporary files that no other process has: tests run side by side.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

namespace macula::test {

/// A path in the folder for temporary files, for this process alone.
inline std::string temporaryPath(const std::string& name) {
  return testing::TempDir() + "macula-" + std::to_string(::getpid()) + "-" + name;
}

}  // namespace macula::test
