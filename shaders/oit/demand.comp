// Slots that each pixel takes at a price a little above and a little below the one found, and the sums
// of each strip: of the least that pixels need, of both, and of all fragments.
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/frame.glsl"
#define BID_VECTORS 1
#include "lib/bidder_inputs.glsl"

layout(r32ui, binding = IMG_0) writeonly uniform uimage2D slotBids;
layout(std430, binding = SSBO_OIT_TOTALS) readonly buffer Totals { OitTotals totals; };
layout(std430, binding = SSBO_STRIP_SUMS) writeonly buffer StripSums { uvec4 stripSums[]; };
#include "lib/price.glsl"
#include "lib/strips.glsl"

void main() {
  ivec2 first = ivec2(int(gl_GlobalInvocationID.x) * STRIP, int(gl_WorkGroupID.y));
  if (first.x >= int(frame.size.x)) return;
  int end = min(first.x + STRIP, int(frame.size.x));
  PriceBounds bounds = priceBounds(PRICE_ROUNDS, frame.oit.y, pixelsPerSample());
  vec4 prices[1] = vec4[](vec4(bounds.high + PRICE_MARGIN, bounds.low - PRICE_MARGIN, 0.0, 0.0));
  uvec4 sum = uvec4(0u);
  for (ivec2 p = first; p.x < end; ++p.x) {
    uint n = min(uint(texelFetch(fragmentCount, p, 0).r), MAX_PIXEL_LAYERS);
    if (n > 0u) {
      uvec4 taken = uvec4(bidAt(p, n, prices).slots[0]);
      uint high = taken.x;
      uint low = max(high, taken.y);
      sum += uvec4(min(n, LEAST_SLOTS), high, low, n);
      imageStore(slotBids, p, uvec4(high | (low << 16)));
    }
  }
  stripSums[stripIndex(first)] = sum;
}
