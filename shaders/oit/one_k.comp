// The largest k for which all pixels together need no more slots than the budget has: the sum over
// pixels of min(n, k) grows, from k to k + 1, by the pixels deeper than k.
#include "shared/oit_constants.h"
layout(local_size_x = 1) in;

#include "lib/frame.glsl"
#include "lib/oit.glsl"

layout(std430, binding = SSBO_STRIP_SUMS) readonly buffer Bins { uint bins[]; };
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };

void main() {
  uint deeper = 0u;
  for (int i = 0; i < COUNT_BINS; ++i) deeper += bins[i];
  uint needed = 0u;
  uint k = 0u;
  while (k < uint(COUNT_BINS) && deeper > 0u && needed + deeper <= frame.oit.y) {
    needed += deeper;
    deeper -= bins[k];
    ++k;
  }
  // Where every pixel of every bin fits, pixels beyond the last bin still keep its k.
  totals.oneLayer = k;
}
