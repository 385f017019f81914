// How many slots a pixel demands at given Lagrange multipliers.
//
// Allocation maximises the sum of the pixels' utilities U_p(k_p) under the budget sum k_p = M. At the
// optimum one multiplier L holds for the whole image, and every pixel takes the slots whose marginal
// utility u_p(k) = U_p(k) - U_p(k - 1) is at least L (Everett 1963, "Generalized Lagrange Multiplier
// Method"). L is, so to speak, the price of a slot. The demand of a pixel of n fragments is
//   UTILITY_UNIFORM        u(k) = 1 / k: the same k everywhere       floor(1 / L)
//   UTILITY_IMPORTANCE     u(k) = I / k: D'Hondt's divisor method    floor(I / L)
//   UTILITY_TRANSMITTANCE  u(k) = transmittance of the slots before  layers until it is below L
//   UTILITY_ERROR          U(k) = -w E(k) (lib/predicted_error.glsl) the k of the least w E(k) + L k
// and at least LEAST_SLOTS, at most n. UTILITY_LEARNED, with UTILITY_ERROR: a network corrects E.
// Multipliers are given as log2; a pixel answers for 4 DEMAND_VECTORS of them at once.
// PACKED, TAIL_IN_SLOT: as for the capture.
#include "lib/oit.glsl"
#include "lib/importance.glsl"
#if defined(UTILITY_TRANSMITTANCE) || defined(UTILITY_ERROR)
#define UTILITY_OF_SLICES
#include "lib/predicted_error.glsl"
#endif
#ifdef UTILITY_ERROR
#include "lib/raster.glsl"
#endif
#ifdef UTILITY_LEARNED
#include "lib/network_output.glsl"
#endif

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
#ifdef UTILITY_IMPORTANCE
layout(r32ui, binding = IMG_2) readonly uniform uimage2D importance;
#endif
#ifdef UTILITY_OF_SLICES
layout(std430, binding = SSBO_SLICES) readonly buffer Slices { uvec4 slices[]; };
#endif
#ifdef UTILITY_ERROR
layout(location = 0) uniform vec2 gazeSettings;  // periphery (d of Vasilakis 2017, Eq. 4), gaze weight
layout(binding = TEX_INPUT1) uniform sampler2D opaqueColor;
layout(location = 1) uniform vec2 pitch;  // samples of the opaque image a pixel; 1 at full rate
#endif

/// Slots, by multiplier.
struct Demand {
  vec4 slots[DEMAND_VECTORS];
};

#ifdef UTILITY_OF_SLICES
#ifdef UTILITY_LEARNED
#define PARTS LEARNED_PARTS
#else
#define PARTS SLICE_PARTS
#endif

/// Slots for so many single fragments and, unless these are all, a tail.
float slotsFor(float fragments, uint n) {
#ifdef TAIL_IN_SLOT
  return min(ceil(fragments) + float(TAIL_SLOTS), float(n));
#else
  return clamp(ceil(fragments), 1.0, float(n));
#endif
}

/// @param behind radiance of the opaque surface · @param weight w of the pixel's error
Demand demandOf(ivec2 p, uint n, vec4 multipliers[DEMAND_VECTORS], vec3 behind, float weight,
                Correction correction) {
  Demand demand;
  for (int v = 0; v < DEMAND_VECTORS; ++v) demand.slots[v] = vec4(n);
  if (n <= LEAST_SLOTS) return demand;
  uint base = sliceBase(p);
  Prefix all = kNothing;
  for (int i = 0; i < SLICES; ++i) {
    uvec4 words = slices[base + uint(i)];
    if (!isEmptySlice(words)) extend(all, layerOf(decodeSlice(words), 1));
  }
  // A tile's slices stand for all of its pixels, whatever their counts.
  float scale = float(n) / max(all.fragments, 1.0);
  Prefix kept = kNothing;
  float slots = slotsFor(0.0, n);
#ifdef UTILITY_ERROR
  vec3 exact = displayed(all.color + all.transmittance * behind);
  float value = weight * predictedError(kept, all, exact, behind, correction, 0, 0.0);
  vec4 each[DEMAND_VECTORS];
  vec4 best[DEMAND_VECTORS];  // the least w E(k) + L k so far
  for (int v = 0; v < DEMAND_VECTORS; ++v) {
    each[v] = exp2(multipliers[v]);
    best[v] = float(n) * each[v];  // everything kept: no error
    vec4 cost = value + slots * each[v];
    bvec4 cheaper = lessThanEqual(cost, best[v]);
    demand.slots[v] = mix(demand.slots[v], vec4(slots), cheaper);
    best[v] = min(best[v], cost);
  }
#endif
  for (int i = 0; i < SLICES; ++i) {
    uvec4 words = slices[base + uint(i)];
    if (isEmptySlice(words)) continue;
    Layer one = layerOf(decodeSlice(words), PARTS);
    for (int j = 0; j < PARTS; ++j) {
#ifdef UTILITY_TRANSMITTANCE
      float tauBefore = kept.tau;
      float slotsBefore = slots;
#endif
      extend(kept, one);
      slots = slotsFor(kept.fragments * scale, n);
#ifdef UTILITY_ERROR
      float part = float(j + 1) / float(PARTS);
      value = weight * predictedError(kept, all, exact, behind, correction, i, part);
      for (int v = 0; v < DEMAND_VECTORS; ++v) {
        vec4 cost = value + slots * each[v];
        demand.slots[v] = mix(demand.slots[v], vec4(slots), lessThan(cost, best[v]));
        best[v] = min(best[v], cost);
      }
#else
      // Where the transmittance falls below the multiplier in this part: between its two ends, as if
      // evenly deep.
      for (int v = 0; v < DEMAND_VECTORS; ++v) {
        vec4 share = clamp((-multipliers[v] - tauBefore) / max(one.tau, 1e-6), 0.0, 1.0);
        bvec4 here = greaterThanEqual(-multipliers[v], vec4(tauBefore));
        demand.slots[v] = mix(demand.slots[v], ceil(mix(vec4(slotsBefore), vec4(slots), share)), here);
      }
#endif
    }
  }
#ifdef UTILITY_TRANSMITTANCE
  for (int v = 0; v < DEMAND_VECTORS; ++v) {
    demand.slots[v] = mix(demand.slots[v], vec4(slotsFor(0.0, n)), lessThan(-multipliers[v], vec4(0.0)));
    demand.slots[v] = mix(demand.slots[v], vec4(n), greaterThanEqual(-multipliers[v], vec4(all.tau)));
  }
#endif
  for (int v = 0; v < DEMAND_VECTORS; ++v) {
    demand.slots[v] = clamp(demand.slots[v], vec4(LEAST_SLOTS), vec4(n));
  }
  return demand;
}
#else
Demand demandOf(uint n, vec4 multipliers[DEMAND_VECTORS], float importance) {
  Demand demand;
  float least = float(min(n, LEAST_SLOTS));
  for (int v = 0; v < DEMAND_VECTORS; ++v) {
    demand.slots[v] = clamp(floor(importance * exp2(-multipliers[v])), vec4(least), vec4(n));
  }
  return demand;
}
#endif

/// Demand of the pixel of n fragments.
Demand demandAt(ivec2 p, uint n, vec4 multipliers[DEMAND_VECTORS]) {
#ifdef UTILITY_OF_SLICES
  vec3 behind = vec3(0.0);
  float weight = 1.0;
  Correction correction = Correction(vec4(1.0), vec4(0.0));
#ifdef UTILITY_ERROR
  if (gazeSettings.y > 0.0) {
    float seen = peripheryFactor(vec2(p) + 0.5, gazeOfFrame(), gazeSettings.x);
    weight = mix(1.0, seen * seen, gazeSettings.y);
  }
  behind = texelFetch(opaqueColor, pixelAt(p, pitch, textureSize(opaqueColor, 0)), 0).rgb;
#endif
#ifdef UTILITY_LEARNED
  NetworkOutput o = outputAt(p);
  correction = Correction(exp2(o.low), kUnknownOrder * exp2(o.high));
#endif
  return demandOf(p, n, multipliers, behind, weight, correction);
#elif defined(UTILITY_IMPORTANCE)
  return demandOf(n, multipliers, float(imageLoad(importance, p).r) / float(IMPORTANCE_ONE));
#else
  return demandOf(n, multipliers, 1.0);
#endif
}
