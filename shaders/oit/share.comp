// Shares out all slots of the budget M. Five amounts are known for the whole image, each at least the
// one before: nothing, the least slots of each pixel, demand at the high multiplier, at the low one, a
// slot for every fragment. Between the two amounts A <= M < B next to the budget, pixel p gets
//   k_p = a_p + floor(r S_p) - floor(r S_(p-1))     r = (M - A) / (B - A)
// with a_p, b_p its own part of A and B and S_p = sum of (b_q - a_q) over all pixels q <= p: its part of
// what B adds, in one even sequence over the image (Bresenham 1965 draws a line so). The k_p add up to M
// exactly, whatever the order of threads, and the prefix sums also say where each range begins.
#include "lib/tile.glsl"

#include "lib/frame.glsl"
#include "lib/slot_range.glsl"
#include "lib/strips.glsl"
#include "lib/cut.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(r32ui, binding = IMG_2) readonly uniform uimage2D slotDemand;
layout(std430, binding = SSBO_OIT_TOTALS) readonly buffer Totals { OitTotals totals; };
layout(std430, binding = SSBO_STRIP_SUMS) readonly buffer StripSums { uvec4 stripSums[]; };

/// A pixel's parts of A and of B - A.
uvec2 partsOf(uvec4 amounts, uint cut) {
  uint own = amountOf(amounts, cut);
  return uvec2(own, cut < 4u ? amounts[cut] - own : 0u);
}

void main() {
  uint cut = totals.cut.x;
  uvec2 ratio = totals.cut.yz;
  ivec2 p = firstPlace();
  int places = placesInside(p, ivec2(frame.size));
#ifndef GROUP_SUMS
  if (places == 0) return;
  uvec2 upTo = partsOf(stripSums[stripIndex(p)] + stripSums[rowIndex(uint(p.y))], cut);
#endif
  for (int i = 0; i < THREAD_PLACES; ++i, p += kPlaceStep) {
    uint n = 0u;
    uvec2 own = uvec2(0u);
    if (i < places) {
      n = min(uint(texelFetch(fragmentCount, p, 0).r), MAX_PIXEL_LAYERS);
      if (n > 0u) {
        own = partsOf(uvec4(min(n, LEAST_SLOTS), unpackDemand(imageLoad(slotDemand, p).r), n), cut);
      }
    }
#ifdef GROUP_SUMS
    uvec2 upTo = sumUpTo(uvec4(own, 0u, 0u), uint(STRIP)).xy;
#else
    upTo += own;
#endif
    if (n > 0u) {
#ifdef GROUP_SUMS
      upTo += partsOf(stripSums[stripIndex(p)] + stripSums[rowIndex(uint(p.y))], cut);
#endif
      uint from = granted(upTo.y - own.y, ratio);
      storeRange(p, n, upTo.x - own.x + from, own.x + granted(upTo.y, ratio) - from);
    }
  }
}
