// Memory barriers from declarations. No GL calls.
#pragma once

#include <array>
#include <span>

#include "engine/frame/pass.h"
#include "engine/gl/gl.h"

namespace macula::frame {

/// Follows the passes of all frames and says which barrier bits each one needs before it runs.
/// Only writes by image store and shader storage are incoherent (OpenGL 4.5, section 7.12.2);
/// render targets and clears are ordered by the driver. What a frame leaves pending stays pending
/// in the next one: glFinish is no memory barrier.
class BarrierTracker {
 public:
  /// The bits for glMemoryBarrier before a pass with these touches; 0 where none is needed. Then
  /// notes what the pass writes.
  GLbitfield before(std::span<const Touch> touches);
  /// The same before resources are cleared by glClearTexImage or glClearNamedBufferData.
  GLbitfield beforeClear(Resource resource);

 private:
  GLbitfield settle(GLbitfield bits);

  /// Per resource: the barrier bits not yet issued since its last incoherent write.
  std::array<GLbitfield, kResourceCount> pending_{};
};

}  // namespace macula::frame
