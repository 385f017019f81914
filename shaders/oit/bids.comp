// Slots that each pixel of a covered tile takes at a price a little above and a little below the one
// found.
#include "shared/dispatch.h"
layout(local_size_x = LIST_GROUP) in;

#include "lib/frame.glsl"
#define BID_VECTORS 1
#include "lib/bidder_inputs.glsl"

layout(r32ui, binding = IMG_0) writeonly uniform uimage2D slotBids;
layout(std430, binding = SSBO_OIT_TOTALS) readonly buffer Totals { OitTotals totals; };
#include "lib/covered.glsl"
#include "lib/price.glsl"

void main() {
  ivec2 tile;
  if (!findCoveredTile(tile)) return;
  vec4 prices[1] = finalPrices();
  for (int i = 0; i < LISTED_TILE * LISTED_TILE; ++i) {
    ivec2 p = tile * LISTED_TILE + ivec2(i % LISTED_TILE, i / LISTED_TILE);
    if (any(greaterThanEqual(p, ivec2(frame.size.xy)))) continue;
    uint n = min(uint(texelFetch(fragmentCount, p, 0).r), MAX_PIXEL_LAYERS);
    if (n > 0u) imageStore(slotBids, p, uvec4(packTaken(bidAt(p, n, prices).slots[0].xy)));
  }
}
