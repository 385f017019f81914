// Sums over each strip of pixels: the least slots that they need, their demand at a multiplier a little
// above and a little below the one found, their fragments.
// DEMAND_STORED: an earlier pass has stored each pixel's demand; else it is found and stored here.
#include "lib/tile.glsl"

#include "lib/frame.glsl"
#include "lib/oit.glsl"
#ifdef DEMAND_STORED
layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(r32ui, binding = IMG_0) readonly uniform uimage2D slotDemand;
#else
#define DEMAND_VECTORS 1
#include "lib/demand.glsl"
layout(r32ui, binding = IMG_0) writeonly uniform uimage2D slotDemand;
layout(std430, binding = SSBO_OIT_TOTALS) readonly buffer Totals { OitTotals totals; };
#include "lib/multiplier.glsl"
#endif
layout(std430, binding = SSBO_STRIP_SUMS) writeonly buffer StripSums { uvec4 stripSums[]; };
#include "lib/strips.glsl"

void main() {
  ivec2 first = firstPlace();
  int places = placesInside(first, ivec2(frame.size));
#ifndef DEMAND_STORED
  vec4 multipliers[1] = finalMultipliers();
#endif
  uvec4 sum = uvec4(0u);
  ivec2 p = first;
  for (int i = 0; i < THREAD_PLACES; ++i, p += kPlaceStep) {
    uint n = i < places ? min(uint(texelFetch(fragmentCount, p, 0).r), MAX_PIXEL_LAYERS) : 0u;
#ifdef GROUP_SUMS
    sum = uvec4(0u);
#endif
    if (n > 0u) {
#ifdef DEMAND_STORED
      uint word = imageLoad(slotDemand, p).r;
#else
      uint word = packDemand(demandAt(p, n, multipliers).slots[0].xy);
      imageStore(slotDemand, p, uvec4(word));
#endif
      sum += uvec4(min(n, LEAST_SLOTS), unpackDemand(word), n);
    }
#ifdef GROUP_SUMS
    sumUpTo(sum, uint(STRIP));
    if (p.x % STRIP == 0 && i < places) stripSums[stripIndex(p)] = sumOfAll(uint(STRIP));
#endif
  }
#ifndef GROUP_SUMS
  if (places > 0) stripSums[stripIndex(first)] = sum;
#endif
}
