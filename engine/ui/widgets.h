// Small pieces that panels share.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace macula::ui {

/// Colours of words that are more than information.
enum class Tone { Plain, Quiet, Good, Warning, Error };

/// Name at the left, value at the right edge of the panel; on a line of its own where both do not
/// fit into one.
void nameValue(std::string_view name, std::string_view value, Tone tone = Tone::Plain);

/// Text over as many lines as it needs.
void note(std::string_view text, Tone tone = Tone::Quiet);

/// Buttons side by side that wrap at the panel's edge; the chosen one is lit.
/// @returns the index of the one that was pressed in this frame
[[nodiscard]] std::optional<std::size_t> chips(std::span<const std::string_view> names,
                                               std::optional<std::size_t> chosen);

/// A button that stays in the line of the one before where there is room for it.
[[nodiscard]] bool flowButton(const std::string& label, bool first);

/// A line over the picture, behind the panels.
/// @param place where it stands, in the UI's coordinates, its top edge there
/// @param anchor which part of its width stands there: 0 left edge, 0.5 middle, 1 right edge
void pictureLabel(std::string_view text, glm::vec2 place, float anchor);

/// Draws the current window over all others, without giving it the keyboard.
void bringToFront();

/// "12.3 KiB", "4.00 MiB"
[[nodiscard]] std::string bytesText(unsigned long long bytes);
/// Digits in groups of three.
[[nodiscard]] std::string countText(unsigned long long count);
/// "1 frame", "2 frames", "1 200 frames"
[[nodiscard]] std::string numberOf(unsigned long long count, std::string_view thing);

}  // namespace macula::ui
