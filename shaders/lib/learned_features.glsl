// Inputs of Macula's own network for a pixel: its depth slices, the error of merging the slices behind
// each of them in a tail (lib/predicted_error.glsl, without its second term), and the opaque colour.
#include "lib/slices.glsl"
#include "lib/raster.glsl"
#include "shared/network.h"

layout(std430, binding = SSBO_SLICES) readonly buffer Slices { uvec4 slices[]; };
layout(binding = TEX_INPUT1) uniform sampler2D opaqueColor;
layout(location = 0) uniform vec2 pitch;  // samples of the opaque image a pixel; 1 at full rate

/// The features of pixel p with n fragments.
void findFeatures(ivec2 p, float n, out float x[INPUTS]) {
  ivec2 at = pixelAt(p, pitch, textureSize(opaqueColor, 0));
  vec3 behind = texelFetch(opaqueColor, at, 0).rgb;
  uint base = sliceBase(p);
  Slice s[LEARNED_SLICES];
  float fragments = 0.0;
  float tau = 0.0;
  vec3 tauColor = vec3(0.0);
  vec3 color = vec3(0.0);  // of all over nothing
  for (int i = 0; i < LEARNED_SLICES; ++i) {
    s[i] = decodeSlice(slices[base + uint(i)]);
    float before = exp2(-tau);
    fragments += s[i].fragments;
    tau += s[i].tau;
    tauColor += s[i].tauColor;
    color += (before - exp2(-tau)) * s[i].tauColor / max(s[i].tau, 1e-6);
  }
  float transmittance = exp2(-tau);
  vec3 exact = displayed(color + transmittance * behind);
  x[0] = log2(n);
  float keptTau = 0.0;
  vec3 keptTauColor = vec3(0.0);
  vec3 kept = vec3(0.0);
  for (int i = 0; i < LEARNED_SLICES; ++i) {
    // Squared error of keeping the slices before this one, with the mean of the others behind them.
    float reaches = exp2(-keptTau);
    vec3 mean = max(tauColor - keptTauColor, 0.0) / max(tau - keptTau, 1e-6);
    vec3 off = exact - displayed(kept + (reaches - transmittance) * mean + transmittance * behind);
    vec3 own = s[i].tauColor / max(s[i].tau, 1e-6);
    keptTau += s[i].tau;
    keptTauColor += s[i].tauColor;
    kept += (reaches - exp2(-keptTau)) * own;
    vec3 ownDisplayed = displayed(own);
    x[1 + i] = log2(dot(off, off) + LEARNED_LEAST_ERROR);
    x[1 + LEARNED_SLICES + i] = exp2(-keptTau);
    x[1 + 2 * LEARNED_SLICES + i] = s[i].fragments / max(fragments, 1.0);
    x[1 + 3 * LEARNED_SLICES + i] = log2(s[i].tau / max(s[i].fragments, 1.0) + LEARNED_LEAST_DEPTH);
    for (int c = 0; c < 3; ++c) x[1 + 4 * LEARNED_SLICES + 3 * i + c] = ownDisplayed[c];
  }
  vec3 behindDisplayed = displayed(behind);
  for (int c = 0; c < 3; ++c) x[1 + 7 * LEARNED_SLICES + c] = behindDisplayed[c];
}
