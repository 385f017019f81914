// A network of importance, evaluated once a tile from the mean of the features of its covered pixels.
// MODEL_THESIS, MODEL_LEARNED: which features. FEATURES_OUT: write each pixel's features instead of
// evaluating. PROBE: evaluate given features, for the check against the program that trained it.
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "shared/network.h"
#include "lib/frame.glsl"
#include "lib/oit.glsl"
#include "lib/network.glsl"
#include "lib/network_output.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
#ifdef MODEL_THESIS
#include "lib/thesis_features.glsl"
#else
#include "lib/learned_features.glsl"
#endif

#if defined(FEATURES_OUT) || defined(PROBE)
layout(std430, binding = SSBO_NETWORK_VALUES) buffer Values { float values[]; };
#else
layout(rgba32ui, binding = IMG_0) writeonly uniform uimage2D tileOutput;
#endif

NetworkOutput outputFrom(float said[OUTPUTS]) {
#ifdef MODEL_THESIS
  return NetworkOutput(vec4(said[0], 0.0, 0.0, 1.0), vec4(0.0));  // never all 0
#else
  vec4 low = vec4(said[0], said[1], said[2], said[3]);
  vec4 high = vec4(said[4], said[5], said[6], said[7]);
  return NetworkOutput(LEARNED_MOST * tanh(low / LEARNED_MOST), LEARNED_MOST * tanh(high / LEARNED_MOST));
#endif
}

void main() {
  float x[INPUTS];
  float said[OUTPUTS];
  for (int i = 0; i < INPUTS; ++i) x[i] = 0.0;
#ifdef PROBE
  uint probe = gl_GlobalInvocationID.x;
  uint at = probe * uint(INPUTS + OUTPUTS);
  if (gl_GlobalInvocationID.y > 0u || at + uint(INPUTS + OUTPUTS) > uint(values.length())) return;
  for (int i = 0; i < INPUTS; ++i) x[i] = values[at + uint(i)];
  evaluateNetwork(x, said);
  for (int i = 0; i < OUTPUTS; ++i) values[at + uint(INPUTS + i)] = said[i];
#else
  ivec2 size = ivec2(frame.size.xy);
  ivec2 first = ivec2(gl_GlobalInvocationID.xy) * NETWORK_TILE;
  if (any(greaterThanEqual(first, size))) return;
  float covered = 0.0;
  for (int i = 0; i < NETWORK_TILE * NETWORK_TILE; ++i) {
    ivec2 p = first + ivec2(i % NETWORK_TILE, i / NETWORK_TILE);
    if (any(greaterThanEqual(p, size))) continue;
    float n = texelFetch(fragmentCount, p, 0).r;
    if (n > 0.0) {
      addFeatures(p, n, x);
      covered += 1.0;
    }
  }
#ifdef FEATURES_OUT
  uint at = uint(first.y * size.x + first.x) * uint(INPUTS);
  for (int i = 0; i < INPUTS; ++i) values[at + uint(i)] = x[i];
#else
  bool any = covered > 0.0;
  for (int i = 0; i < INPUTS; ++i) x[i] /= max(covered, 1.0);
  for (int i = 0; i < OUTPUTS; ++i) said[i] = 0.0;
  if (any) evaluateNetwork(x, said);
  uvec4 words = encodeOutput(outputFrom(said));
  imageStore(tileOutput, ivec2(gl_GlobalInvocationID.xy), any ? words : uvec4(0u));
#endif
#endif
}
