// Command lines as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace macula {

/// A word as a POSIX shell reads it back: as it is where that is safe, else in single quotes.
[[nodiscard]] std::string shellQuoted(std::string_view word);

/// Quoted words with blanks between them.
[[nodiscard]] std::string shellCommand(const std::vector<std::string>& words);

}  // namespace macula
