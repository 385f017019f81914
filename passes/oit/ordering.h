// Per-pixel ordering: how the read-modify-write operations of one pixel's fragments exclude each
// other.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/gl/capabilities.h"
#include "engine/gl/program.h"

namespace macula::passes {

enum class SyncMode : std::uint8_t {
  Auto,       ///< interlock, else ordered where it holds, else spinlock
  Interlock,  ///< GL_ARB_fragment_shader_interlock
  Spinlock,   ///< one bounded lock a pixel
  Ordered,    ///< the rasteriser itself runs a pixel's fragments one after another on one thread
  None,       ///< no mutual exclusion: hazards on purpose
};

[[nodiscard]] std::string_view nameOf(SyncMode mode);
/// @param name a value of the setting oit.sync
[[nodiscard]] SyncMode syncByName(std::string_view name);

/// Outcome of the self-test behind SyncMode::Ordered.
struct OrderedCheck {
  bool allowed = false;  ///< the renderer is on the list of rasterisers known to draw so
  bool passed = false;
  std::string reason;  ///< one line
};

/// Draws overlapping triangles whose fragments read, change and write one word per pixel without
/// atomics, and compares every pixel with the same sequence on the CPU.
[[nodiscard]] OrderedCheck checkOrdered(const gl::Capabilities& capabilities,
                                        gl::ProgramCache& programs);

/// The mode that a device uses for a setting.
/// @throws InputError where the device does not support what was asked for
[[nodiscard]] SyncMode chooseSync(SyncMode asked, const gl::Capabilities& capabilities,
                                  const OrderedCheck& ordered);

}  // namespace macula::passes
