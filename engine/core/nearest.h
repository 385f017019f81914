// The known name that is most like a mistyped one, for error messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace macula {

/// The shortest candidate that begins with `name`, where that has three characters or more; else
/// the one with the least edit distance to it (Levenshtein 1966: insertions, deletions,
/// substitutions). Both without regard to case; the first of several; empty where there are none.
[[nodiscard]] std::string nearestName(std::string_view name,
                                      std::span<const std::string> candidates);

}  // namespace macula
