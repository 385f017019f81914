// SHA-256 (FIPS 180-4) by OpenSSL.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace macula {

/// 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256Hex(std::span<const std::byte> bytes);

/// Of a file's bytes. @throws InputError as readTextFile()
[[nodiscard]] std::string fileSha256(const std::filesystem::path& file);

}  // namespace macula
