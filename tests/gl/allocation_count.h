// Counts what C++ code allocates.
#pragma once

#include <cstddef>

namespace macula::test {

/// Calls of operator new since the program started. The driver, which is C, is not in it.
[[nodiscard]] std::size_t allocationCount();

}  // namespace macula::test
