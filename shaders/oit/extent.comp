// Totals of the image for the features of the thesis's network: number of fragments, covered pixels,
// nearest and farthest depth.
#include "lib/tile.glsl"

#include "lib/frame.glsl"
#include "lib/oit.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(binding = TEX_INPUT1) uniform sampler2D depthRange;
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };

void main() {
  uint sum = 0u;
  uint covered = 0u;
  float nearest = 0.0;
  float farthest = 1.0;
  ivec2 p = firstPlace();
  int places = placesInside(p, ivec2(frame.size));
  for (int i = 0; i < places; ++i, p += kPlaceStep) {
    float n = texelFetch(fragmentCount, p, 0).r;
    if (n == 0.0) continue;
    sum += uint(n);
    ++covered;
    vec2 range = texelFetch(depthRange, p, 0).rg;
    nearest = max(nearest, range.x);
    farthest = min(farthest, -range.y);
  }
  // Positive floats order as their bits do; the complement turns a minimum into a maximum, so that
  // 0 is the start of both.
  uvec4 own = uvec4(sum, floatBitsToUint(nearest), ~floatBitsToUint(farthest), covered);
  uvec4 all = groupTotal(own, bvec4(false, true, true, false));
  if (!addsForGroup() || all.w == 0u) return;
  atomicAdd(totals.extent.x, all.x);
  atomicMax(totals.extent.y, all.y);
  atomicMax(totals.extent.z, all.z);
  atomicAdd(totals.extent.w, all.w);
}
