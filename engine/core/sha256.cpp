#include "engine/core/sha256.h"

#include <openssl/sha.h>

#include <array>

#include "engine/core/file.h"

namespace macula {

std::string sha256Hex(std::span<const std::byte> bytes) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest.data());
  constexpr char kDigits[] = "0123456789abcdef";
  std::string hex;
  hex.reserve(digest.size() * 2);
  for (const unsigned char byte : digest) {
    hex.push_back(kDigits[byte >> 4]);
    hex.push_back(kDigits[byte & 15]);
  }
  return hex;
}

std::string fileSha256(const std::filesystem::path& file) {
  const std::string bytes = readTextFile(file);
  return sha256Hex(std::as_bytes(std::span(bytes)));
}

}  // namespace macula
