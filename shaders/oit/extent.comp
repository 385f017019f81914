// Totals of the image for the features of the thesis's network: number of fragments, covered pixels,
// nearest and farthest depth. A thread walks a strip of pixels and adds to the totals once.
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/frame.glsl"
#include "lib/oit.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(binding = TEX_INPUT1) uniform sampler2D depthRange;
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };

void main() {
  ivec2 first = ivec2(int(gl_GlobalInvocationID.x) * STRIP, int(gl_WorkGroupID.y));
  int end = min(first.x + STRIP, int(frame.size.x));
  uint sum = 0u;
  uint covered = 0u;
  float nearest = 0.0;
  float farthest = 1.0;
  for (ivec2 p = first; p.x < end; ++p.x) {
    float n = texelFetch(fragmentCount, p, 0).r;
    if (n == 0.0) continue;
    sum += uint(n);
    ++covered;
    vec2 range = texelFetch(depthRange, p, 0).rg;
    nearest = max(nearest, range.x);
    farthest = min(farthest, -range.y);
  }
  if (sum == 0u) return;
  atomicAdd(totals.extent.x, sum);
  atomicAdd(totals.extent.w, covered);
  // Positive floats order as their bits do; the complement turns a minimum into a maximum, so that
  // 0 is the start of both.
  atomicMax(totals.extent.y, floatBitsToUint(nearest));
  atomicMax(totals.extent.z, ~floatBitsToUint(farthest));
}
