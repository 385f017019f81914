// Number of slots of each pixel, k(p), and where they begin: contiguous ranges, allocated by one atomic
// cursor, with one atomic addition a strip.
// ALLOCATION_EXACT: k = n. ALLOCATION_ONE_K: k = min(n, k of the image) (Vasilakis and Fudos 2014).
// ALLOCATION_IMPORTANCE (Vasilakis 2017, Eq. 1, changed so that the sum stays within the budget M and
// no covered pixel is left empty where M is at least the number C of them):
//   k = max(1, floor(I (M - Z) / sum I)), Z pixels whose floor(I (M - C) / sum I) is 0 (oit/reserve.comp)
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/frame.glsl"
#include "lib/slot_range.glsl"
#include "lib/budget.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
#ifdef ALLOCATION_IMPORTANCE
layout(r32ui, binding = IMG_2) readonly uniform uimage2D importance;
#endif
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };

#ifdef ALLOCATION_IMPORTANCE
/// Whether a pixel gets a layer where there are fewer slots than covered pixels: the strip's share of
/// the slots goes to its most important pixels, one layer each. Shares are rounded down, so their sum
/// stays within the budget.
bool winsOneLayer(ivec2 p, ivec2 first, int end, uint own, uint stripSlots) {
  uint rank = 0u;  // pixels of the strip that are more important, or as important and further left
  for (ivec2 q = first; q.x < end; ++q.x) {
    if (texelFetch(fragmentCount, q, 0).r == 0.0 || q.x == p.x) continue;
    uint other = imageLoad(importance, q).r;
    if (other > own || (other == own && q.x < p.x)) ++rank;
  }
  return rank < stripSlots;
}
#endif

void main() {
  ivec2 first = ivec2(int(gl_GlobalInvocationID.x) * STRIP, int(gl_WorkGroupID.y));
  int end = min(first.x + STRIP, int(frame.size.x));
  uint slots = frame.slots;
  uint layers[STRIP];
  uint sum = 0u;
#ifdef ALLOCATION_IMPORTANCE
  double total = double(totals.importanceHigh) * 4294967296.0lf + double(totals.importanceLow);
  bool scarce = slots < totals.covered;
  uint divisible = scarce ? 0u : slots - totals.starved;
  uint stripSlots = 0u;
  if (scarce) {
    uint stripCovered = 0u;
    for (ivec2 p = first; p.x < end; ++p.x) {
      if (texelFetch(fragmentCount, p, 0).r > 0.0) ++stripCovered;
    }
    stripSlots = uint(floor(double(stripCovered) * double(slots) / double(totals.covered)));
  }
#endif
  for (int i = 0; first.x + i < end; ++i) {
    ivec2 p = ivec2(first.x + i, first.y);
    uint k = 0u;
    uint n = uint(texelFetch(fragmentCount, p, 0).r);
    if (n > 0u) {
#if defined(ALLOCATION_EXACT)
      k = n;
#elif defined(ALLOCATION_ONE_K)
      k = min(n, totals.oneLayer);
#else
      uint own = imageLoad(importance, p).r;
      if (scarce) {
        k = winsOneLayer(p, first, end, own, stripSlots) ? 1u : 0u;
      } else {
        k = max(1u, share(own, divisible, total));
      }
#endif
    }
    layers[i] = k;
    sum += k;
  }
  if (sum == 0u) return;
  uint begin = atomicAdd(totals.cursor, sum);
  for (int i = 0; first.x + i < end; ++i) {
    ivec2 p = ivec2(first.x + i, first.y);
    uint k = layers[i];
    if (k == 0u) continue;
    // Exact allocation may ask for more than the pool holds: what does not fit gets no slot.
    uint fits = begin < slots ? min(k, slots - begin) : 0u;
    storeRange(p, uint(texelFetch(fragmentCount, p, 0).r), begin, fits);
    begin += k;
  }
}
