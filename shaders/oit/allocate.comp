// Number of slots of each pixel, k(p), and where they begin: contiguous ranges, allocated by one atomic
// cursor.
// ALLOCATION_EXACT: k = n. ALLOCATION_ONE_K: k = min(n, k of the image) (Vasilakis and Fudos 2014).
// ALLOCATION_IMPORTANCE (Vasilakis 2017, Eq. 1, changed so that the sum stays within the budget M and
// no covered pixel is left empty where M is at least the number C of them):
//   k = max(1, floor(I (M - Z) / sum I)), Z pixels whose floor(I (M - C) / sum I) is 0 (oit/reserve.comp)
#include "lib/tile.glsl"

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
bool winsOneLayer(ivec2 p, uint own) {
  uint covered = 0u;
  uint rank = 0u;  // pixels of the strip that are more important, or as important and further left
  ivec2 q = ivec2(p.x / STRIP * STRIP, p.y);
  int end = min(q.x + STRIP, int(frame.size.x));
  for (; q.x < end; ++q.x) {
    if (texelFetch(fragmentCount, q, 0).r == 0.0) continue;
    ++covered;
    uint other = imageLoad(importance, q).r;
    if (other > own || (other == own && q.x < p.x)) ++rank;
  }
  return rank < share(covered, budgetOf(frame.slots, uvec2(totals.covered, 0u)));
}
#endif

void main() {
  ivec2 first = firstPlace();
  int places = placesInside(first, ivec2(frame.size));
  uint slots = frame.slots;
  uint layers[THREAD_PLACES];
  uint sum = 0u;
#ifdef ALLOCATION_IMPORTANCE
  uvec2 total = uvec2(totals.importanceLow, totals.importanceHigh);
  bool scarce = slots < totals.covered;
  Budget budget = budgetOf(scarce ? 0u : slots - totals.starved, total);
#endif
  ivec2 p = first;
  for (int i = 0; i < places; ++i, p += kPlaceStep) {
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
        k = winsOneLayer(p, own) ? 1u : 0u;
      } else {
        k = max(1u, share(own, budget));
      }
#endif
    }
    layers[i] = k;
    sum += k;
  }
  GroupPlace range = placeInGroup(sum);
  uint begin = 0u;
  if (addsForGroup() && range.total > 0u) begin = atomicAdd(totals.cursor, range.total);
  begin = fromAdder(begin) + range.before;
  if (sum == 0u) return;
  p = first;
  for (int i = 0; i < places; ++i, p += kPlaceStep) {
    uint k = layers[i];
    if (k == 0u) continue;
    // Exact allocation may ask for more than the pool holds: what does not fit gets no slot.
    uint fits = begin < slots ? min(k, slots - begin) : 0u;
    storeRange(p, uint(texelFetch(fragmentCount, p, 0).r), begin, fits);
    begin += k;
  }
}
