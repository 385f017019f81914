// One round of the search for the price of a slot, in a sample of the pixels. A thread walks a strip
// of them and adds to the totals once.
// ROUND: 0 .. PRICE_ROUNDS - 1
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/frame.glsl"
#define BID_VECTORS PRICE_VECTORS
#include "lib/bidder_inputs.glsl"

layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
#include "lib/price.glsl"

void main() {
  int stride = int(frame.oit.z);
  int width = (int(frame.size.x) + stride - 1) / stride;
  int first = int(gl_GlobalInvocationID.x) * STRIP;
  int end = min(first + STRIP, width);
  PriceBounds bounds = priceBounds(ROUND, frame.oit.y, pixelsPerSample());
  vec4 prices[PRICE_VECTORS];
  uvec4 demand[PRICE_VECTORS];
  for (int v = 0; v < PRICE_VECTORS; ++v) {
    for (int i = 0; i < 4; ++i) prices[v][i] = candidatePrice(bounds, 4 * v + i);
    demand[v] = uvec4(0u);
  }
  uint covered = 0u;
  for (int x = first; x < end; ++x) {
    // A place in the cell that changes from cell to cell, so that no pattern of the scene is met.
    uint h = hashPcg(uint(x) + hashPcg(gl_WorkGroupID.y));
    ivec2 p = ivec2(x, int(gl_WorkGroupID.y)) * stride +
              ivec2(int(h >> 8) % stride, int(h >> 20) % stride);
    p = min(p, ivec2(frame.size.xy) - 1);
    uint n = uint(texelFetch(fragmentCount, p, 0).r);
    if (n == 0u) continue;
    ++covered;
    Bids bids = bidAt(p, n, prices);
    for (int v = 0; v < PRICE_VECTORS; ++v) demand[v] += uvec4(bids.slots[v]);
  }
  if (covered == 0u) return;
  for (int v = 0; v < PRICE_VECTORS; ++v) {
    for (int i = 0; i < 4; ++i) atomicAdd(totals.priceDemand[ROUND * PRICE_VECTORS + v][i], demand[v][i]);
  }
}
