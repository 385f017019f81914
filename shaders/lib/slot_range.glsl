// Records the range of slots that an allocation gives a pixel, and empties its tail.
// TAIL_IN_SLOT: pixels with more fragments than slots have a tail (lib/oit.glsl).
#define RANGES
#include "lib/oit.glsl"
#ifdef TAIL_IN_SLOT
#define STORE_ACCESS
#include "lib/fragment_store.glsl"
#endif

layout(rg32ui, binding = IMG_0) writeonly uniform uimage2D fragmentRange;

/// @param n fragments of the pixel · @param k its slots, from `first` on
void storeRange(ivec2 p, uint n, uint first, uint k) {
#ifdef TAIL_IN_SLOT
  if (hasTail(n, k)) {
    uint capacity = k - TAIL_SLOTS;
    storeTail(first + capacity, vec4(0.0));
    imageStore(fragmentRange, p, uvec4(first, capacity | RANGE_TAIL, 0u, 0u));
    return;
  }
#endif
  if (k > 0u) imageStore(fragmentRange, p, uvec4(first, k, 0u, 0u));
}
