// What the allocation gave to each pixel.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gl_fixture.h"

namespace macula::test {

/// What the allocation gave to one pixel.
struct Given {
  std::uint32_t first = 0;
  std::uint32_t slots = 0;  ///< of single fragments and of the tail
  std::uint32_t count = 0;  ///< fragments
};

/// Rows from the bottom.
[[nodiscard]] std::vector<Given> givenBy(const Bench& bench);

/// Checks ranges against the pool and each other. @returns the slots given in all
std::uint64_t expectDisjoint(const std::vector<Given>& given, std::uint64_t slots,
                             const std::string& what);

}  // namespace macula::test
