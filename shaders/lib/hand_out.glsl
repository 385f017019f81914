// Gives a pixel its slots and empties what the capture fills.
// LOCKS: reset the spin locks. FRONT_NORMAL: reset the history that the capture writes.
#define RANGES
#define STORE_ACCESS
#include "lib/fragment_store.glsl"

layout(rg32ui, binding = IMG_0) writeonly uniform uimage2D fragmentRange;
layout(r32ui, binding = IMG_1) writeonly uniform uimage2D fragmentFill;
#ifdef FRONT_NORMAL
layout(rgba8_snorm, binding = IMG_3) writeonly uniform image2D frontNormal;
#endif
#ifdef LOCKS
layout(r32ui, binding = IMG_4) writeonly uniform uimage2D fragmentLock;
#endif

/// @param n fragments of the pixel · @param k its slots, from `first` on
void handOut(ivec2 p, uint n, uint first, uint k) {
  uint capacity = k;
  if (hasTail(n, k)) {
    capacity = k - TAIL_SLOTS;
    storeTail(first + capacity, vec4(0.0));
    imageStore(fragmentRange, p, uvec4(first, capacity | RANGE_TAIL, 0u, 0u));
  } else {
    imageStore(fragmentRange, p, uvec4(first, capacity, 0u, 0u));
  }
  imageStore(fragmentFill, p, uvec4(0u));
#ifdef FRONT_NORMAL
  imageStore(frontNormal, p, vec4(0.0));
#endif
#ifdef LOCKS
  imageStore(fragmentLock, p, uvec4(0u));
#endif
}
