// Slots that each pixel takes at a price a little above and a little below the one found, and the sums
// of each strip: of the least that pixels need, of both, and of all fragments.
// BIDS_IN: an earlier pass has said what pixels take.
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/frame.glsl"
#include "lib/oit.glsl"
#ifdef BIDS_IN
layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(r32ui, binding = IMG_0) readonly uniform uimage2D slotBids;
#else
#define BID_VECTORS 1
#include "lib/bidder_inputs.glsl"
layout(r32ui, binding = IMG_0) writeonly uniform uimage2D slotBids;
#endif
layout(std430, binding = SSBO_OIT_TOTALS) readonly buffer Totals { OitTotals totals; };
layout(std430, binding = SSBO_STRIP_SUMS) writeonly buffer StripSums { uvec4 stripSums[]; };
#include "lib/price.glsl"
#include "lib/strips.glsl"

void main() {
  ivec2 first = ivec2(int(gl_GlobalInvocationID.x) * STRIP, int(gl_WorkGroupID.y));
  if (first.x >= int(frame.size.x)) return;
  int end = min(first.x + STRIP, int(frame.size.x));
#ifndef BIDS_IN
  vec4 prices[1] = finalPrices();
#endif
  uvec4 sum = uvec4(0u);
  for (ivec2 p = first; p.x < end; ++p.x) {
    uint n = min(uint(texelFetch(fragmentCount, p, 0).r), MAX_PIXEL_LAYERS);
    if (n > 0u) {
#ifdef BIDS_IN
      uint word = imageLoad(slotBids, p).r;
#else
      uint word = packTaken(bidAt(p, n, prices).slots[0].xy);
      imageStore(slotBids, p, uvec4(word));
#endif
      sum += uvec4(min(n, LEAST_SLOTS), unpackTaken(word), n);
    }
  }
  stripSums[stripIndex(first)] = sum;
}
