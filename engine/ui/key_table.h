// Keys and what they do, as a page over the image.
#pragma once

#include <span>
#include <string_view>

namespace macula::ui {

struct KeyRow {
  std::string_view group;
  std::string_view keys;
  std::string_view what;
};

/// Draws the rows under a heading for each group, in the middle of the window and scrolled where it
/// is too small. Rows of a group stand together.
/// @returns whether the page was closed in this frame
[[nodiscard]] bool drawKeyTable(std::span<const KeyRow> rows);

}  // namespace macula::ui
