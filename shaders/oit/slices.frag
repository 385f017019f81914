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

/// Smaller than any product of differences of depths; a pixel of one depth must not divide by 0.
const float kLeastDepth = 1e-30;

/// Place w of a depth between the nearest and the farthest fragment along the view axis, 0..1. Reversed
/// depths z are distances c / (a + z); c and one division cancel.
/// @param range as oit/count.frag writes it
float wayOf(float depth, vec2 range) {
  float a = frame.nearPlane / (frame.farPlane - frame.nearPlane);
  float nearest = range.x;
  float farthest = -range.y;
  float part = (nearest - depth) * (a + farthest);
  float whole = (nearest - farthest) * (a + depth);
#ifdef LEARNED
  // 2 w / (1 + w) in place of w: slices are thinner towards the eye, where fragments weigh most.
  part *= 2.0;
  whole += 0.5 * part;
#endif
  return clamp(part / max(whole, kLeastDepth), 0.0, 1.0);
}

void main() {
#ifdef HOLED
  if (!isThere()) return;
#endif
  vec4 c = approximateTransparent();
  float alpha = clamp(c.a, 0.0, 1.0);
  float tau = min(opticalDepth(alpha), SLICE_MAX_DEPTH);
  vec3 color = clamp(c.rgb / max(alpha, 1e-6), vec3(0.0), vec3(SLICE_MAX_COLOR));
  ivec2 first = ivec2(gl_FragCoord.xy) * SLICE_TILE;
  vec2 range = texelFetch(depthRange, first, 0).rg;
  for (int i = 1; i < SLICE_TILE * SLICE_TILE; ++i) {
    ivec2 p = min(first + ivec2(i % SLICE_TILE, i / SLICE_TILE), ivec2(frame.size) - 1);
    range = max(range, texelFetch(depthRange, p, 0).rg);
  }
  float way = wayOf(gl_FragCoord.z, range);
  uint slice = min(uint(way * float(SLICES)), uint(SLICES) - 1u);
  uint at = sliceBase(first) + slice;
  uvec4 words = encodeSlice(tau, color);
#ifdef SYNC_ORDERED
  slices[at] += withCarry(words, slices[at].x);
#else
  words = withCarry(words, atomicAdd(slices[at].x, words.x));
  atomicAdd(slices[at].y, words.y);
  atomicAdd(slices[at].z, words.z);
  atomicAdd(slices[at].w, words.w);
#endif
}
