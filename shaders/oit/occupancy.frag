// Marks the depth interval of a fragment as occupied. SYNC_ORDERED: the rasteriser draws a pixel's fragments in
// order on one thread; else atomics.
layout(early_fragment_tests) in;

#include "lib/material.glsl"
#include "lib/occupancy.glsl"

void main() {
#ifdef HOLED
  if (!isThere()) return;
#endif
  ivec2 p = ivec2(gl_FragCoord.xy);
  if (slotsIfCrowded(p) == 0u) return;
  uint interval = intervalOf(intervalsAt(p), floatBitsToUint(gl_FragCoord.z));
  uint word = firstWord(p) + interval / 32u;
  uint bit = 1u << (interval % 32u);
  if ((occupancy[word] & bit) != 0u) return;
#ifdef SYNC_ORDERED
  occupancy[word] |= bit;
#else
  atomicOr(occupancy[word], bit);
#endif
}
