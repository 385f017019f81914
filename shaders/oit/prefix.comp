// Turns the sums of strips into the sums of all strips before them in their row, and leaves the sum of
// the row. GROUP_SUMS: STRIP threads a row. Else a thread takes a row.
#include "shared/dispatch.h"
#ifdef GROUP_SUMS
#define GROUP_THREADS SCAN_GROUP
#else
#define GROUP_THREADS PREFIX_ROWS
#endif
layout(local_size_x = GROUP_THREADS) in;

#include "lib/frame.glsl"
#include "lib/strips.glsl"

layout(std430, binding = SSBO_STRIP_SUMS) buffer StripSums { uvec4 stripSums[]; };

#ifdef GROUP_SUMS
#include "lib/group_scan.glsl"

void main() {
  uint strips = stripsPerRow();
  uint lane = gl_LocalInvocationIndex % uint(STRIP);
  for (uint i = gl_LocalInvocationIndex / uint(STRIP); i < uint(PREFIX_ROWS); i += uint(SCAN_GROUP / STRIP)) {
    uint row = gl_WorkGroupID.y * uint(PREFIX_ROWS) + i;
    bool inside = row < uint(frame.size.y);
    uvec4 before = uvec4(0u);
    for (uint first = 0u; first < strips; first += uint(STRIP)) {
      uint at = row * strips + first + lane;
      bool there = inside && first + lane < strips;
      uvec4 own = there ? stripSums[at] : uvec4(0u);
      uvec4 upTo = sumUpTo(own, uint(STRIP));
      if (there) stripSums[at] = before + upTo - own;
      before += sumOfAll(uint(STRIP));
    }
    if (inside && lane == 0u) stripSums[rowIndex(row)] = before;
  }
}
#else
void main() {
  uint row = gl_WorkGroupID.y * uint(PREFIX_ROWS) + gl_LocalInvocationIndex;
  if (row >= uint(frame.size.y)) return;
  uint strips = stripsPerRow();
  uvec4 before = uvec4(0u);
  for (uint i = row * strips; i < (row + 1u) * strips; ++i) {
    uvec4 own = stripSums[i];
    stripSums[i] = before;
    before += own;
  }
  stripSums[rowIndex(row)] = before;
}
#endif
