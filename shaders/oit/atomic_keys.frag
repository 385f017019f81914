// The k least keys of each pixel by cascades of atomic minima (Maule et al. 2013, section 4): the value
// that a slot evicts goes on to the next. First the depths; STAGE_IDS: then, among the slots with the
// fragment's depth, the ids, so that fragments of equal depth have a slot each, the lowest ids first.
layout(early_fragment_tests) in;

#include "lib/frame.glsl"
#define STORE_ACCESS coherent
#define KEYS_ONLY
#include "lib/fragment_store.glsl"
#include "lib/material.glsl"

void main() {
#ifdef HOLED
  if (!isThere()) return;
#endif
  ivec2 p = ivec2(gl_FragCoord.xy);
  uint k = frame.pixelSlots;
  uint first = uint(p.y * int(frame.size.x) + p.x) * k;
  uint depth = fragmentKey(gl_FragCoord.z, 0u).x;
#ifndef STAGE_IDS
  // The last slot only ever comes nearer: a fragment behind it now will not be kept.
  if (depth >= keys[first + k - 1u].x) return;
  uint value = depth;
  for (uint i = 0u; i < k && value != NO_KEY; ++i) {
    value = max(value, atomicMin(keys[first + i].x, value));
  }
#else
  if (depth > keys[first + k - 1u].x) return;
  uint value = fragmentId();
  for (uint i = 0u; i < k && value != NO_KEY; ++i) {
    if (keys[first + i].x == depth) value = max(value, atomicMin(keys[first + i].y, value));
  }
#endif
}
