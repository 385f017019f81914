// Slots of each pixel and where they begin: contiguous ranges handed out by one cursor, one atomic
// a strip. Also resets what the capture fills.
// ALLOCATION_EXACT: k = n. ALLOCATION_IMPORTANCE: k from the importance map under the budget.
// LOCKS: reset the spin locks. FRONT_NORMAL: reset the history that the capture writes.
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/frame.glsl"
#include "lib/oit.glsl"
#include "lib/budget.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(rg32ui, binding = IMG_0) writeonly uniform uimage2D fragmentRange;
layout(r32ui, binding = IMG_1) writeonly uniform uimage2D fragmentFill;
#ifdef ALLOCATION_IMPORTANCE
layout(r32ui, binding = IMG_2) readonly uniform uimage2D importance;
#endif
#ifdef FRONT_NORMAL
layout(rgba8_snorm, binding = IMG_3) writeonly uniform image2D frontNormal;
#endif
#ifdef LOCKS
layout(r32ui, binding = IMG_4) writeonly uniform uimage2D fragmentLock;
#endif
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
layout(location = 0) uniform uint slots;

#ifdef ALLOCATION_IMPORTANCE
/// With fewer slots than covered pixels: the strip's fair share of them goes to its most important
/// pixels, one layer each. The shares are rounded down, so their sum stays within the budget.
/// Rank: pixels of the strip that are more important, or as important and further left.
bool winsOneLayer(ivec2 p, ivec2 first, int end, uint own, uint stripSlots) {
  uint rank = 0u;
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
  uint layers[STRIP];
  uint sum = 0u;
  uint stored = 0u;
  uint kMax = 0u;
  uint kMinInverted = 0u;
  uint generated = 0u;
  uint covered = 0u;
  uint countMax = 0u;
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
    uint n = uint(texelFetch(fragmentCount, p, 0).r);
    uint k = n;
    if (n > 0u) {
#ifdef ALLOCATION_IMPORTANCE
      uint own = imageLoad(importance, p).r;
      if (scarce) {
        k = winsOneLayer(p, first, end, own, stripSlots) ? 1u : 0u;
      } else {
        k = max(1u, share(own, divisible, total));
      }
#endif
      kMax = max(kMax, k);
      kMinInverted = max(kMinInverted, ~k);
      generated += n;
      ++covered;
      countMax = max(countMax, n);
      stored += min(n, k);
    }
    layers[i] = k;
    sum += k;
    imageStore(fragmentFill, p, uvec4(0u));
#ifdef FRONT_NORMAL
    imageStore(frontNormal, p, vec4(0.0));
#endif
#ifdef LOCKS
    imageStore(fragmentLock, p, uvec4(0u));
#endif
  }
  uint begin = 0u;
  if (sum > 0u) begin = atomicAdd(totals.cursor, sum);
  // Exact allocation may ask for more than the pool holds: what does not fit gets no slot.
  for (int i = 0; first.x + i < end; ++i) {
    uint k = layers[i];
    uint fits = begin < slots ? min(k, slots - begin) : 0u;
    imageStore(fragmentRange, ivec2(first.x + i, first.y), uvec4(begin, fits, 0u, 0u));
    begin += k;
  }
  if (generated == 0u) return;
  atomicAdd(totals.stored, stored);
  atomicMax(totals.kMax, kMax);
  atomicMax(totals.kMinInverted, kMinInverted);
#ifdef ALLOCATION_EXACT
  atomicAdd(totals.generated, generated);
  atomicAdd(totals.covered, covered);
  atomicMax(totals.countMax, countMax);
#endif
}
