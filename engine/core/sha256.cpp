#include "engine/core/sha256.h"

#include <fmt/ranges.h>
#include <openssl/sha.h>

#include <array>

#include "engine/core/file.h"

namespace macula {

std::string sha256Hex(std::span<const std::byte> bytes) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest.data());
  return fmt::format("{:02x}", fmt::join(digest, ""));
}

std::string fileSha256(const std::filesystem::path& file) {
  const std::string bytes = readTextFile(file);
  return sha256Hex(std::as_bytes(std::span(bytes)));
}

}  // namespace macula
