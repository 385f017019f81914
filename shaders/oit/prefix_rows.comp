// Turns the sums of rows into the sums of all rows before them, leaves those of the image in the totals,
// and finds where the budget cuts them (oit/share.comp). By one group, each thread some rows.
#include "shared/dispatch.h"
#include "shared/oit_totals.h"
#define GROUP_THREADS SCAN_GROUP
layout(local_size_x = SCAN_GROUP) in;

#include "lib/frame.glsl"
#include "lib/group_scan.glsl"
#include "lib/strips.glsl"

layout(std430, binding = SSBO_STRIP_SUMS) buffer StripSums { uvec4 stripSums[]; };
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
#include "lib/cut.glsl"

void main() {
  uint rows = uint(frame.size.y);
  uint each = (rows + uint(SCAN_GROUP) - 1u) / uint(SCAN_GROUP);
  uint first = rowIndex(min(gl_LocalInvocationIndex * each, rows));
  uint end = rowIndex(min((gl_LocalInvocationIndex + 1u) * each, rows));
  uvec4 sum = uvec4(0u);
  for (uint i = first; i < end; ++i) sum += stripSums[i];
  uvec4 before = sumUpTo(sum, uint(SCAN_GROUP)) - sum;
  for (uint i = first; i < end; ++i) {
    uvec4 own = stripSums[i];
    stripSums[i] = before;
    before += own;
  }
  if (gl_LocalInvocationIndex != uint(SCAN_GROUP) - 1u) return;
  totals.demand = before;
  totals.cut = cutOf(before, frame.slots);
}
