// Messages of the driver: errors and warnings of KHR_debug, collected and counted.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gl/gl.h"

namespace macula::gl {

/// Receives the debug messages of the current context for as long as it lives.
/// Errors, undefined behaviour and deprecated use are kept; performance hints and notes are not.
class DebugLog {
 public:
  DebugLog();
  ~DebugLog();
  DebugLog(const DebugLog&) = delete;
  DebugLog& operator=(const DebugLog&) = delete;

  [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }
  [[nodiscard]] bool outOfMemory() const { return outOfMemory_; }
  void clear() { messages_.clear(); }
  void add(GLenum type, GLuint id, std::string_view text);

 private:
  std::vector<std::string> messages_;
  bool outOfMemory_ = false;
};

/// Whether the current context was made to be debugged.
[[nodiscard]] bool isDebugContext();
/// Sends a mistake of the program as a debug message, which a DebugLog keeps.
void reportMistake(std::string_view mistake);

/// A named group of commands in debuggers, from construction to destruction.
class DebugGroup {
 public:
  explicit DebugGroup(std::string_view name);
  ~DebugGroup();
  DebugGroup(const DebugGroup&) = delete;
  DebugGroup& operator=(const DebugGroup&) = delete;
};

}  // namespace macula::gl
