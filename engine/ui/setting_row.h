// One setting as a widget that fits its type, range and unit.
#pragma once

#include <optional>

#include "engine/settings/entry.h"

namespace macula::ui {

/// A value that is being dragged or typed and is not set yet.
struct PendingEdit {
  const settings::Entry* entry = nullptr;  ///< null: none
  settings::Value value;
};

/// Draws the widget of one setting, as wide as ImGui::SetNextItemWidth() said. Real numbers report
/// each step of a drag, typed ones when the field is left; whole numbers, which size buffers,
/// report when the edit ends, and text on Enter.
/// @param pending the edit in progress, of this or another setting; kept between frames
/// @returns the value that the user chose in this frame; it has not been checked or set
[[nodiscard]] std::optional<settings::Value> drawSettingWidget(const settings::Entry& entry,
                                                               PendingEdit& pending);

}  // namespace macula::ui
