// Shares out all slots of the budget M. Five amounts are known for the whole image, each at least the
// one before: nothing, the least slots of each pixel, demand at the high multiplier, at the low one, a
// slot for every fragment. Between the two amounts A <= M < B next to the budget, pixel p gets
//   k_p = a_p + floor(r S_p) - floor(r S_(p-1))     r = (M - A) / (B - A)
// with a_p, b_p its own part of A and B and S_p = sum of (b_q - a_q) over all pixels q <= p: its part of
// what B adds, in one even sequence over the image (Bresenham 1965 draws a line so). The k_p add up to M
// exactly, whatever the order of threads, and the prefix sums also say where each range begins.
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/frame.glsl"
#include "lib/slot_range.glsl"
#include "lib/strips.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(r32ui, binding = IMG_2) readonly uniform uimage2D slotDemand;
layout(std430, binding = SSBO_OIT_TOTALS) readonly buffer Totals { OitTotals totals; };
layout(std430, binding = SSBO_STRIP_SUMS) readonly buffer StripSums { uvec4 stripSums[]; };

/// floor(r S). The offset keeps floor() from falling below a whole number that rounding has just missed;
/// it is smaller than any step of the quotient that matters and larger than the error of the product.
uint granted(uint wanted, double ratio) { return uint(floor(double(wanted) * ratio + 2.4e-7lf)); }

/// @param amount -1: nothing
uint amountOf(uvec4 amounts, int amount) { return amount < 0 ? 0u : amounts[amount]; }

void main() {
  ivec2 first = ivec2(int(gl_GlobalInvocationID.x) * STRIP, int(gl_WorkGroupID.y));
  if (first.x >= int(frame.size.x)) return;
  int end = min(first.x + STRIP, int(frame.size.x));
  uint slots = min(frame.slots, totals.demand.w);
  int lower = -1;
  while (lower < 3 && totals.demand[lower + 1] <= slots) ++lower;
  uint base = amountOf(totals.demand, lower);
  uint extra = lower < 3 ? totals.demand[lower + 1] - base : 0u;
  double ratio = extra > 0u ? double(slots - base) / double(extra) : 0.0lf;

  uvec4 before = stripSums[stripIndex(first)] + stripSums[rowIndex(uint(first.y))];
  uint given = amountOf(before, lower);
  uint wanted = lower < 3 ? before[lower + 1] - given : 0u;
  uint from = granted(wanted, ratio);
  for (ivec2 p = first; p.x < end; ++p.x) {
    uint n = min(uint(texelFetch(fragmentCount, p, 0).r), MAX_PIXEL_LAYERS);
    uint k = 0u;
    if (n > 0u) {
      uvec4 amounts = uvec4(min(n, LEAST_SLOTS), unpackDemand(imageLoad(slotDemand, p).r), n);
      uint own = amountOf(amounts, lower);
      uint more = lower < 3 ? amounts[lower + 1] - own : 0u;
      wanted += more;
      uint to = granted(wanted, ratio);
      k = own + to - from;
      storeRange(p, n, given + from, k);
      given += own;
      from = to;
    }
  }
}
