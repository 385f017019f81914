// Sums transparent fragments into the depth slices of their tile.
// LEARNED: slices that are thinner towards the eye.
// SYNC_ORDERED: the rasteriser draws a pixel's fragments in order on one thread; else atomics.
layout(early_fragment_tests) in;

#include "lib/oit.glsl"
#include "lib/slices.glsl"
#include "shared/network.h"
#include "lib/transparent.glsl"

layout(binding = TEX_INPUT1) uniform sampler2D depthRange;
layout(std430, binding = SSBO_SLICES) buffer Slices { uvec4 slices[]; };

/// Along the view axis, of a reversed depth.
float viewDistance(float depth) {
  float nearPlane = frame.slices.x;
  float farPlane = frame.slices.y;
  return nearPlane * farPlane / (nearPlane + depth * (farPlane - nearPlane));
}

void main() {
  vec4 c = approximateTransparent();
  float alpha = clamp(c.a, 0.0, 1.0);
  float tau = min(opticalDepth(alpha), SLICE_MAX_DEPTH);
  vec3 color = clamp(c.rgb / max(alpha, 1e-6), vec3(0.0), vec3(SLICE_MAX_COLOR));
  int tile = int(frame.slices.w);
  uint count = uint(frame.slices.z);
  ivec2 first = ivec2(gl_FragCoord.xy) * tile;
  vec2 range = texelFetch(depthRange, first, 0).rg;
  for (int i = 1; i < tile * tile; ++i) {
    ivec2 p = min(first + ivec2(i % tile, i / tile), ivec2(frame.size.xy) - 1);
    range = max(range, texelFetch(depthRange, p, 0).rg);
  }
  float nearest = viewDistance(range.x);
  float x = (viewDistance(gl_FragCoord.z) - nearest) / max(viewDistance(-range.y) - nearest, 1e-6);
  x = clamp(x, 0.0, 1.0);
#ifdef LEARNED
  x = pow(x, LEARNED_SLICE_POWER);
#endif
  uint slice = min(uint(x * float(count)), count - 1u);
  uint at = sliceBase(first) + slice;
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
