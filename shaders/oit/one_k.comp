// The one k of kb-plus (Vasilakis and Fudos 2014): the largest k with sum over pixels of min(n, k) <= M.
// From k to k + 1 that sum grows by the number of pixels with more than k fragments.
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
  while (k < uint(COUNT_BINS) && deeper > 0u && needed + deeper <= frame.slots) {
    needed += deeper;
    deeper -= bins[k];
    ++k;
  }
  // Pixels beyond the last bin keep its k at most.
  totals.oneLayer = k;
}
