// Demand of each pixel of a covered tile at a multiplier a little above and a little below the one
// found. For utilities that take much work: only covered tiles are visited.
#include "shared/dispatch.h"
layout(local_size_x = LIST_GROUP) in;

#include "lib/frame.glsl"
#define DEMAND_VECTORS 1
#include "lib/demand.glsl"

layout(r32ui, binding = IMG_0) writeonly uniform uimage2D slotDemand;
layout(std430, binding = SSBO_OIT_TOTALS) readonly buffer Totals { OitTotals totals; };
#include "lib/covered.glsl"
#include "lib/multiplier.glsl"

void main() {
  ivec2 tile;
  if (!findCoveredTile(tile)) return;
  vec4 multipliers[1] = finalMultipliers();
  for (int i = 0; i < LISTED_TILE * LISTED_TILE; ++i) {
    ivec2 p = tile * LISTED_TILE + ivec2(i % LISTED_TILE, i / LISTED_TILE);
    if (any(greaterThanEqual(p, ivec2(frame.size)))) continue;
    uint n = min(uint(texelFetch(fragmentCount, p, 0).r), MAX_PIXEL_LAYERS);
    if (n > 0u) imageStore(slotDemand, p, uvec4(packDemand(demandAt(p, n, multipliers).slots[0].xy)));
  }
}
