// SHA-256 (FIPS 180-4) of a block of bytes, by OpenSSL.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace macula {

/// 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256Hex(std::span<const std::byte> bytes);

}  // namespace macula
