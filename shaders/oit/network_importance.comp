// Importance of each pixel by the network's output, and its sum. A thread walks a strip of pixels and
// adds to the totals once. FACTORS: also as a float, for heat maps.
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/frame.glsl"
#include "lib/oit.glsl"
#include "lib/network_output.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(r32ui, binding = IMG_0) writeonly uniform uimage2D importance;
#ifdef FACTORS
layout(rgba16f, binding = IMG_1) writeonly uniform image2D factors;
#endif
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };

void main() {
  ivec2 first = ivec2(int(gl_GlobalInvocationID.x) * STRIP, int(gl_WorkGroupID.y));
  int end = min(first.x + STRIP, int(frame.size.x));
  uint sum = 0u;
  uint covered = 0u;
  uint countMax = 0u;
  for (ivec2 p = first; p.x < end; ++p.x) {
    float count = texelFetch(fragmentCount, p, 0).r;
    if (count == 0.0) continue;
    float predicted = clamp(outputAt(p).low.x, 0.0, 1.0);
    uint value = uint(predicted * float(IMPORTANCE_ONE) + 0.5);
    sum += value;
    ++covered;
    countMax = max(countMax, uint(count));
    imageStore(importance, p, uvec4(value));
#ifdef FACTORS
    imageStore(factors, p, vec4(0.0, 0.0, 0.0, predicted));
#endif
  }
  if (covered == 0u) return;
  uint old = atomicAdd(totals.importanceLow, sum);
  if (old + sum < old) atomicAdd(totals.importanceHigh, 1u);
  atomicAdd(totals.covered, covered);
  atomicMax(totals.countMax, countMax);
}
