// Sums transparent fragments into the depth slices of their tile.
// SYNC_ORDERED: the rasteriser draws a pixel's fragments in order on one thread; else atomics.
layout(early_fragment_tests) in;

#include "lib/oit.glsl"
#include "lib/slices.glsl"
#define APPROXIMATE
#include "lib/transparent.glsl"

layout(std430, binding = SSBO_SLICES) buffer Slices { uvec4 slices[]; };

void main() {
  vec4 c = approximateTransparent();
  float alpha = clamp(c.a, 0.0, 1.0);
  float tau = min(opticalDepth(alpha), SLICE_MAX_DEPTH);
  vec3 color = clamp(c.rgb / max(alpha, 1e-6), vec3(0.0), vec3(SLICE_MAX_COLOR));
  // Equal ratios of distance, as perspective crowds what is far.
  float x = log2(distance(inPosition, frame.eye.xyz) / frame.slices.x) /
            log2(frame.slices.y / frame.slices.x);
  int tile = int(frame.slices.w);
  uint count = uint(frame.slices.z);
  uint at = sliceBase(ivec2(gl_FragCoord.xy) * tile) + min(uint(max(x, 0.0) * float(count)), count - 1u);
  uvec4 words = encodeSlice(tau, color);
#ifdef SYNC_ORDERED
  slices[at] += words;
#else
  atomicAdd(slices[at].x, words.x);
  atomicAdd(slices[at].y, words.y);
  atomicAdd(slices[at].z, words.z);
  atomicAdd(slices[at].w, words.w);
#endif
}
