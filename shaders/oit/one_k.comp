// The one k of kb-plus (Vasilakis and Fudos 2014): the largest k with sum over pixels of min(n, k) <= M.
// From k to k + 1 that sum grows by the number of pixels with more than k fragments. By one group, each
// thread some bins.
#include "shared/dispatch.h"
#include "shared/oit_totals.h"
#define GROUP_THREADS SCAN_GROUP
layout(local_size_x = SCAN_GROUP) in;

#include "lib/frame.glsl"
#include "lib/group_scan.glsl"

layout(std430, binding = SSBO_STRIP_SUMS) readonly buffer Bins { uint bins[]; };
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };

#define THREAD_BINS (COUNT_BINS / SCAN_GROUP)

/// Whether a sum whose halves of 16 bits were summed apart is within the slots; the halves cannot
/// overflow.
bool isAffordable(uvec2 halves) {
  uint high = halves.y + (halves.x >> 16);
  return high < 1u << 16 && (high << 16 | halves.x & 0xFFFFu) <= frame.slots;
}

void main() {
  int first = int(gl_LocalInvocationIndex) * THREAD_BINS;
  uint own[THREAD_BINS];
  uint pixels = 0u;
  for (int i = 0; i < THREAD_BINS; ++i) {
    own[i] = bins[first + i];
    pixels += own[i];
  }
  uint upTo = sumUpTo(uvec4(pixels, 0u, 0u, 0u), uint(SCAN_GROUP)).x;
  // Pixels with more than `first` fragments, and what one more layer for each number of them adds.
  uint deeper = sumOfAll(uint(SCAN_GROUP)).x - (upTo - pixels);
  uint added[THREAD_BINS];
  uvec2 needed = uvec2(0u);
  for (int i = 0; i < THREAD_BINS; ++i) {
    added[i] = deeper;
    needed += uvec2(deeper & 0xFFFFu, deeper >> 16);
    deeper -= own[i];
  }
  needed = sumUpTo(uvec4(needed, 0u, 0u), uint(SCAN_GROUP)).xy - needed;
  uint k = 0u;  // of this thread's bins, those whose layer is needed and within the budget
  for (int i = 0; i < THREAD_BINS; ++i) {
    needed += uvec2(added[i] & 0xFFFFu, added[i] >> 16);
    if (added[i] > 0u && isAffordable(needed)) ++k;
  }
  uint all = sumUpTo(uvec4(k, 0u, 0u, 0u), uint(SCAN_GROUP)).x;
  // Pixels beyond the last bin keep its k at most.
  if (gl_LocalInvocationIndex == uint(SCAN_GROUP) - 1u) totals.oneLayer = all;
}
