#include "engine/scene/gltf_uri.h"

#include <openssl/evp.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <system_error>
#include <utility>

#include "engine/core/error.h"

namespace macula::scene::gltf {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kShownUriBytes = 120;  // a message stays readable where a URI is data

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// Whether a URI starts with a scheme ("http:"), RFC 3986 section 3.1.
bool hasScheme(std::string_view uri) {
  const std::size_t colon = uri.find_first_of(":/?#");
  return colon != std::string_view::npos && colon > 0 && uri[colon] == ':' &&
         std::isalpha(static_cast<unsigned char>(uri[0])) != 0;
}

std::vector<std::byte> readDataUri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64")) {
    failInput("its data URI is not base64; export the file again");
  }
  auto bytes = base64Decode(uri.substr(comma + 1));
  if (!bytes) failInput("its data URI holds characters outside base64; export the file again");
  return std::move(*bytes);
}

}  // namespace

std::string percentDecode(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size()) {
      const int high = hexDigit(text[i + 1]);
      const int low = hexDigit(text[i + 2]);
      if (high >= 0 && low >= 0) {
        decoded.push_back(static_cast<char>(high * 16 + low));
        i += 2;
        continue;
      }
    }
    decoded.push_back(text[i]);
  }
  return decoded;
}

std::optional<std::vector<std::byte>> base64Decode(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  // OpenSSL takes whole groups of four, and padding anywhere for zeros.
  if (text.find('=') != std::string_view::npos || text.size() % 4 == 1) return std::nullopt;
  std::string padded(text);
  padded.resize((text.size() + 3) / 4 * 4, '=');
  std::vector<std::byte> bytes(padded.size() / 4 * 3);
  const int decoded = EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                                      reinterpret_cast<const unsigned char*>(padded.data()),
                                      static_cast<int>(padded.size()));
  if (std::cmp_not_equal(decoded, bytes.size())) return std::nullopt;  // blanks around it, too
  bytes.resize(text.size() * 3 / 4);
  return bytes;
}

std::vector<std::byte> readUri(const std::string& uri, const fs::path& folder,
                               std::uint64_t maxBytes) {
  if (uri.starts_with("data:")) return readDataUri(uri);
  const std::string shown = uri.substr(0, kShownUriBytes);
  const std::string decoded = percentDecode(uri);
  if (hasScheme(uri) || decoded.starts_with('/') || decoded.find('\0') != std::string::npos) {
    failInput("'{}' is not a relative path; put the file beside the glTF file", shown);
  }
  if (folder.empty()) {
    failInput("'{}' is another file, and none can be read from here; embed it", shown);
  }
  const fs::path path = folder / decoded;
  std::error_code error;
  // Only regular files: a pipe or a device could block or never end.
  if (!fs::is_regular_file(path, error)) {
    failInput("'{}' is missing or no file; put it there", shown);
  }
  const std::uintmax_t size = fs::file_size(path, error);
  std::ifstream in(path, std::ios::binary);
  if (error || !in) failInput("'{}' cannot be read; check its permissions", shown);
  std::vector<std::byte> bytes(static_cast<std::size_t>(std::min<std::uintmax_t>(size, maxBytes)));
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

}  // namespace macula::scene::gltf
