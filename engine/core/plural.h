// Numbers with their nouns in messages: "1 frame", "2 frames".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace macula {

/// The form of a noun that goes with a number: "frame" with 1, "frames" with any other.
/// @param plural of nouns that take more than an s; empty: the noun with an s
[[nodiscard]] std::string nounFor(std::uint64_t count, std::string_view noun,
                                  std::string_view plural = {});

/// The number and the noun: "1 frame", "0 frames", "3 hashes".
[[nodiscard]] std::string counted(std::uint64_t count, std::string_view noun,
                                  std::string_view plural = {});

}  // namespace macula
