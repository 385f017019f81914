// What a file is that is no gaze log, so that the error can say where it belongs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace macula::gaze {

/// How many bytes foreignBytes() looks at.
inline constexpr std::size_t kForeignBytes = 512;

/// By the first bytes: scenes, archives, JSON, other binary data.
/// @param start the first kForeignBytes bytes of the file, or fewer where it ends
/// @returns what it is and what to do instead; nothing for text that may be a gaze log
[[nodiscard]] std::optional<std::string> foreignBytes(std::string_view start);

/// By the columns of the header: camera paths, and exports of trackers that no reader is for.
/// @returns likewise
[[nodiscard]] std::optional<std::string> foreignTable(std::string_view header);

}  // namespace macula::gaze
