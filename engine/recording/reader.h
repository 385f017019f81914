// Reads the folder of a recording.
#pragma once

#include <filesystem>

#include "engine/recording/recording.h"

namespace macula::recording {

/// Whether the folder holds a recording's session.json.
[[nodiscard]] bool isRecording(const std::filesystem::path& folder);

/// Reads session.json and frames.jsonl; a session that died before its first frame has none.
/// @throws InputError naming file, line and fix
[[nodiscard]] Recording readRecording(const std::filesystem::path& folder);

}  // namespace macula::recording
