// Bytes that a glTF file names by URI: data URIs and files beside it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace macula::scene::gltf {

/// Undoes percent-encoding (RFC 3986, section 2.1); a '%' without two digits stays.
[[nodiscard]] std::string percentDecode(std::string_view text);

/// Decodes base64 (RFC 4648, section 4), with or without padding; nothing where it is malformed.
/// @param text less than 2 GiB
[[nodiscard]] std::optional<std::vector<std::byte>> base64Decode(std::string_view text);

/// Reads what a URI names: "data:...;base64,..." or a path relative to `folder`.
/// @param maxBytes of a file, at most these are read
/// @throws InputError "what; fix", without the place, which the caller knows
[[nodiscard]] std::vector<std::byte> readUri(const std::string& uri,
                                             const std::filesystem::path& folder,
                                             std::uint64_t maxBytes);

}  // namespace macula::scene::gltf
