// Whether every buffer block that a program declares is backed by a buffer, in debug contexts.
#pragma once

#include <string>

#include "engine/gl/gl.h"

namespace macula::gl {

/// Follows the blocks of programs while contexts are debugged; elsewhere every call returns at
/// once.
///
/// A block with the layout std140 or std430 is active even where no statement uses it, and an
/// active block without a buffer, or with one that is too small, makes the results of the shader
/// undefined (OpenGL 4.5, sections 7.6 and 7.8). Drivers differ in what they make of it: Mesa's
/// llvmpipe ignores such a block, its zink takes the buffer of one block for another's.
///
/// What it finds is sent as a debug message of the application (glDebugMessageInsert), which
/// gl::DebugLog keeps.
class BlockCheck {
 public:
  /// Looks at the flags of the current context; from then on, checks where it is a debug context.
  static void enableInDebugContext();
  [[nodiscard]] static bool enabled();
  /// Sends a mistake of the program as a debug message.
  static void report(const std::string& mistake);
  /// Unbinds the storage buffers, so that a buffer of an earlier pass backs nothing by accident.
  static void beginPass();
  /// Checks the program in use, right before a draw or dispatch.
  static void beforeUse();
};

}  // namespace macula::gl
