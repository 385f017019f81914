// Half precision (IEEE 754-2008 binary16) to single, without any type of the host.
#pragma once

#include <cstdint>

namespace macula::network {

/// Exact: every half is a float, subnormal ones too; infinities and NaN stay what they are.
[[nodiscard]] float floatOfHalf(std::uint16_t half);

}  // namespace macula::network
