// Evaluates a network of importance once for each covered tile, from the features of the tile's deepest
// pixel: errors are largest there, and the mean of all its pixels was hardly better for many times the
// work.
// MODEL_THESIS, MODEL_LEARNED: which features. FEATURES_OUT: write each pixel's features instead of
// evaluating. PROBE: evaluate given features, for the check against the program that trained it.
#include "shared/dispatch.h"
#ifdef FEATURES_OUT
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;
#else
layout(local_size_x = LIST_GROUP) in;
#endif

#include "shared/network.h"
#include "shared/bindings.h"
#include "lib/network.glsl"
#ifndef PROBE
#include "lib/oit.glsl"
#include "lib/network_output.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
#if defined(MODEL_THESIS) || !defined(FEATURES_OUT)
layout(std430, binding = SSBO_OIT_TOTALS) readonly buffer Totals { OitTotals totals; };
#endif
#ifdef MODEL_THESIS
#include "lib/thesis_features.glsl"
#else
#include "lib/learned_features.glsl"
#endif
#endif

#if defined(FEATURES_OUT) || defined(PROBE)
layout(std430, binding = SSBO_NETWORK_VALUES) buffer Values { float values[]; };
#else
layout(rgba32ui, binding = IMG_0) writeonly uniform uimage2D tileOutput;
#include "lib/covered.glsl"
#endif

#if !defined(FEATURES_OUT) && !defined(PROBE)
NetworkOutput outputFrom(float y[OUTPUTS]) {
#ifdef MODEL_THESIS
  return NetworkOutput(vec4(y[0], 0.0, 0.0, 1.0), vec4(0.0));  // never all 0
#else
  vec4 low = vec4(y[0], y[1], y[2], y[3]);
  vec4 high = vec4(y[4], y[5], y[6], y[7]);
  return NetworkOutput(LEARNED_MOST * tanh(low / LEARNED_MOST), LEARNED_MOST * tanh(high / LEARNED_MOST));
#endif
}
#endif

void main() {
  float x[INPUTS];
#ifdef PROBE
  float y[OUTPUTS];
  uint at = gl_GlobalInvocationID.x * uint(INPUTS + OUTPUTS);
  if (at + uint(INPUTS + OUTPUTS) > uint(values.length())) return;
  for (int i = 0; i < INPUTS; ++i) x[i] = values[at + uint(i)];
  evaluateNetwork(x, y);
  for (int i = 0; i < OUTPUTS; ++i) values[at + uint(INPUTS + i)] = y[i];
#elif defined(FEATURES_OUT)
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = ivec2(frame.size);
  if (any(greaterThanEqual(p, size))) return;
  float n = texelFetch(fragmentCount, p, 0).r;
  for (int i = 0; i < INPUTS; ++i) x[i] = 0.0;
  if (n > 0.0) findFeatures(p, n, x);
  uint at = uint(p.y * size.x + p.x) * uint(INPUTS);
  for (int i = 0; i < INPUTS; ++i) values[at + uint(i)] = x[i];
#else
  float y[OUTPUTS];
  ivec2 tile;
  if (!findCoveredTile(tile)) return;
  float most = 0.0;
  ivec2 deepest = ivec2(0);
  for (int i = 0; i < LISTED_TILE * LISTED_TILE; ++i) {
    ivec2 p = tile * LISTED_TILE + ivec2(i % LISTED_TILE, i / LISTED_TILE);
    if (any(greaterThanEqual(p, ivec2(frame.size)))) continue;
    float n = texelFetch(fragmentCount, p, 0).r;
    if (n > most) {
      most = n;
      deepest = p;
    }
  }
  findFeatures(deepest, most, x);
  evaluateNetwork(x, y);
  imageStore(tileOutput, tile, encodeOutput(outputFrom(y)));
#endif
}
