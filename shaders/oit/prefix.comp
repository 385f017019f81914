// Turns the sums of strips into the sums of all strips before them. A thread takes a row; then, ROWS:
// one thread takes the sums of all rows, and leaves those of the image in the totals.
#include "shared/oit_constants.h"
#ifdef ROWS
layout(local_size_x = 1) in;
#else
layout(local_size_x = STRIP_GROUP) in;
#endif

#include "lib/frame.glsl"
#include "lib/oit.glsl"
#include "lib/strips.glsl"

layout(std430, binding = SSBO_STRIP_SUMS) buffer StripSums { uvec4 stripSums[]; };
#ifdef ROWS
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
#endif

void main() {
#ifdef ROWS
  uint first = rowIndex(0u);
  uint count = uint(frame.size.y);
#else
  uint row = gl_GlobalInvocationID.x;
  if (row >= uint(frame.size.y)) return;
  uint count = stripsPerRow();
  uint first = row * count;
#endif
  uvec4 before = uvec4(0u);
  for (uint i = 0u; i < count; ++i) {
    uvec4 own = stripSums[first + i];
    stripSums[first + i] = before;
    before += own;
  }
#ifdef ROWS
  totals.demand = before;
#else
  stripSums[rowIndex(row)] = before;
#endif
}
