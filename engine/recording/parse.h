// The text of a recording's files, read back.
#pragma once

#include <istream>
#include <string>
#include <string_view>

#include "engine/recording/recording.h"

namespace macula::recording {

/// session.json. @param file stands in messages
/// @throws InputError naming the file and what is wrong, also for a schema that is not known
[[nodiscard]] Session parseSession(std::string_view text, const std::string& file);

/// One line of frames.jsonl. @param line its number, from 1
/// @throws InputError naming file, line and what is wrong
[[nodiscard]] Frame parseFrame(std::string_view text, const std::string& file, std::size_t line);

/// All lines of frames.jsonl. A last line without its end was being written when the program died:
/// it is dropped and counted.
/// @throws InputError naming file and line where one cannot be understood, frames do not count up
///   from 0, or the first of them is not drawn as by a new renderer
[[nodiscard]] Recording parseFrames(std::istream& in, const std::string& file);

}  // namespace macula::recording
