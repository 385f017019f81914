// The known name that is most like a mistyped one, for error messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace macula {

/// The candidate with the least edit distance to `name` (Levenshtein 1966: insertions, deletions,
/// substitutions; here without regard to case); the first of several; empty where there are none.
[[nodiscard]] std::string nearestName(std::string_view name,
                                      std::span<const std::string> candidates);

}  // namespace macula
