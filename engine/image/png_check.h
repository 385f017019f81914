// A look over a PNG file before it is decoded.
#pragma once

#include <filesystem>

namespace macula::image {

/// Walks over the chunks of a PNG (W3C PNG, 3rd edition, 5.3) and checks that none is cut off, that
/// every CRC is right, that the header and the end are there and that its sides are allowed. Damage
/// is found here with its place, before a decoder prints its own words on it.
/// @throws InputError naming the file and the byte.
void checkPng(const std::filesystem::path& path);

}  // namespace macula::image
