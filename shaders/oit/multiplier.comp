// One round of the search for the Lagrange multiplier: demand at each candidate, summed over a sample
// of the covered pixels. A thread takes every MULTIPLIER_THREADS-th of them and adds to the totals once.
// ROUND: 0 .. MULTIPLIER_ROUNDS - 1
#include "shared/dispatch.h"
layout(local_size_x = LIST_GROUP) in;
#define GROUP_THREADS LIST_GROUP
#include "lib/group_sums.glsl"

#include "lib/frame.glsl"
#define DEMAND_VECTORS MULTIPLIER_VECTORS_A_ROUND
#include "lib/demand.glsl"

layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
#include "lib/covered.glsl"
#include "lib/multiplier.glsl"

void main() {
  uint samples = totals.dispatches[LIST_OF_SAMPLES].w;
  if (gl_WorkGroupID.x * uint(LIST_GROUP) >= samples) return;
  MultiplierBounds bounds = multiplierBounds(ROUND, frame.slots, pixelsPerSample());
  vec4 multipliers[DEMAND_VECTORS];
  uvec4 sum[DEMAND_VECTORS];
  for (int v = 0; v < DEMAND_VECTORS; ++v) {
    for (int i = 0; i < 4; ++i) multipliers[v][i] = candidateMultiplier(bounds, 4 * v + i);
    sum[v] = uvec4(0u);
  }
  for (uint entry = gl_GlobalInvocationID.x; entry < samples; entry += uint(MULTIPLIER_THREADS)) {
    ivec2 p = placeOf(entry);
    Demand demand = demandAt(p, uint(texelFetch(fragmentCount, p, 0).r), multipliers);
    for (int v = 0; v < DEMAND_VECTORS; ++v) sum[v] += uvec4(demand.slots[v]);
  }
  for (int v = 0; v < DEMAND_VECTORS; ++v) {
    uvec4 all = groupTotal(sum[v], bvec4(false));
    if (!addsForGroup() || all == uvec4(0u)) continue;
    for (int i = 0; i < 4; ++i) {
      atomicAdd(totals.sampledDemand[ROUND * DEMAND_VECTORS + v][i], all[i]);
    }
  }
}
