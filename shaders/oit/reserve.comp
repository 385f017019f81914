// Counts the covered pixels whose share of M - C slots rounds to no layer, Z of oit/allocate.comp,
// which reserves one layer for each of them.
#include "lib/tile.glsl"

#include "lib/frame.glsl"
#include "lib/oit.glsl"
#include "lib/budget.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(r32ui, binding = IMG_0) readonly uniform uimage2D importance;
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };

void main() {
  uint slots = frame.slots;
  if (slots < totals.covered) return;  // not one layer each: oit/allocate.comp selects pixels
  uvec2 total = uvec2(totals.importanceLow, totals.importanceHigh);
  uint least = slots - totals.covered;
  uint starved = 0u;
  ivec2 p = firstPlace();
  int places = placesInside(p, ivec2(frame.size));
  for (int i = 0; i < places; ++i, p += kPlaceStep) {
    // Both fetches at once: waiting for the count first took longer than what it saves.
    bool isCovered = texelFetch(fragmentCount, p, 0).r > 0.0;
    if (hasNoShare(imageLoad(importance, p).r, least, total) && isCovered) ++starved;
  }
  uint all = groupTotal(uvec4(starved, 0u, 0u, 0u), bvec4(false)).x;
  if (addsForGroup() && all > 0u) atomicAdd(totals.starved, all);
}
