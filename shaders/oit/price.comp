// One round of the search for the price of a slot, in a sample of the covered pixels. A thread takes
// every PRICE_THREADS-th of them and adds to the totals once.
// ROUND: 0 .. PRICE_ROUNDS - 1
#include "shared/dispatch.h"
layout(local_size_x = LIST_GROUP) in;

#include "lib/frame.glsl"
#define BID_VECTORS PRICE_VECTORS
#include "lib/bidder_inputs.glsl"

layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
#include "lib/covered.glsl"
#include "lib/price.glsl"

void main() {
  uint samples = totals.dispatches[LIST_OF_SAMPLES].w;
  if (gl_GlobalInvocationID.x >= samples) return;
  PriceBounds bounds = priceBounds(ROUND, frame.oit.y, pixelsPerSample());
  vec4 prices[PRICE_VECTORS];
  uvec4 demand[PRICE_VECTORS];
  for (int v = 0; v < PRICE_VECTORS; ++v) {
    for (int i = 0; i < 4; ++i) prices[v][i] = candidatePrice(bounds, 4 * v + i);
    demand[v] = uvec4(0u);
  }
  for (uint entry = gl_GlobalInvocationID.x; entry < samples; entry += uint(PRICE_THREADS)) {
    ivec2 p = placeOf(entry);
    Bids bids = bidAt(p, uint(texelFetch(fragmentCount, p, 0).r), prices);
    for (int v = 0; v < PRICE_VECTORS; ++v) demand[v] += uvec4(bids.slots[v]);
  }
  for (int v = 0; v < PRICE_VECTORS; ++v) {
    for (int i = 0; i < 4; ++i) atomicAdd(totals.priceDemand[ROUND * PRICE_VECTORS + v][i], demand[v][i]);
  }
}
