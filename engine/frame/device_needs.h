// What a pass needs of the device: from its table before anything is made, and from its programs,
// by which the tables are checked.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/frame/binding.h"
#include "engine/gl/limits.h"

namespace macula::frame {

struct Need {
  gl::Limit limit;
  std::int64_t amount;
};

/// The most that any program of a pass can need, over its steps and the rows that rest. Without the
/// bytes of buffers, which FrameResources refuses with what would fit. No GL.
[[nodiscard]] std::vector<Need> needsOf(const PassDeclaration& table);
/// What a linked program needs; of a compute shader also its threads.
[[nodiscard]] std::vector<Need> needsOf(GLuint program);

/// A pass that the device cannot run.
struct Shortage {
  std::string pass;
  Need need;
  std::int64_t offered;

  /// "pass 'a' needs 9 image units (GL_MAX_IMAGE_UNITS), and this GPU has 8"
  [[nodiscard]] std::string describe() const;
};

/// The first need that exceeds its limit.
[[nodiscard]] std::optional<Shortage> shortageOf(std::string_view pass,
                                                 const std::vector<Need>& needs,
                                                 const gl::Limits& limits);

}  // namespace macula::frame
