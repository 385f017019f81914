// A file that presses keys and asks for actions at given frames: for tests and demonstrations.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "walk/request.h"

namespace macula::tools {

/// Requests by frame, in the order of the file.
class Script {
 public:
  Script() = default;
  /// One step a line: FRAME ACTION [ARGUMENT], frames not decreasing; # begins a comment line.
  /// `press KEY` asks for what the key does; other actions are those of actionNames().
  /// @param name stands for the file in messages
  /// @throws InputError naming file and line
  Script(std::string_view text, const std::string& name);

  /// Appends what is due at a frame and has not been given yet.
  void due(int frame, Requests& requests);

 private:
  struct Step {
    int frame = 0;
    Request request;
  };
  std::vector<Step> steps_;
  std::size_t next_ = 0;
};

/// Reads a script. @throws InputError
[[nodiscard]] Script readScript(const std::filesystem::path& file);

}  // namespace macula::tools
