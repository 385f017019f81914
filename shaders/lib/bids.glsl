// What a pixel would pay for its slots. Each further slot has a price that the pixel is ready to pay,
// lower than that of the one before; at one price for the whole image every pixel takes the slots
// that are worth it, and the budget decides the price. All prices are given as log2, and a pixel
// answers for BID_VECTORS times four of them at once.
// BID_UNIFORM: 1 / k. BID_IMPORTANCE: I / k, so that k follows importance (D'Hondt's method with the
// pixel's fragments as a cap). BID_TRANSMITTANCE: what passes the slots before. BID_ERROR: how much
// the predicted squared error falls. BID_LEARNED, with BID_ERROR: a network corrects the prediction.
// PACKED, TAIL_IN_SLOT: as for the capture.
#include "lib/oit.glsl"
#include "lib/importance.glsl"

struct Bids {
  vec4 slots[BID_VECTORS];
};

#if defined(BID_TRANSMITTANCE) || defined(BID_ERROR)
#include "lib/slices.glsl"
#include "shared/network.h"
#ifdef BID_LEARNED
#define BID_PARTS LEARNED_PARTS
#else
#define BID_PARTS SLICE_PARTS
#endif
layout(std430, binding = SSBO_SLICES) readonly buffer Slices { uvec4 slices[]; };

/// Slots for so many single fragments and, unless these are all, a tail.
float slotsFor(float fragments, uint n) {
#ifdef TAIL_IN_SLOT
  return min(ceil(fragments) + float(TAIL_SLOTS), float(n));
#else
  return clamp(ceil(fragments), 1.0, float(n));
#endif
}

#ifdef BID_ERROR
#include "lib/shown.glsl"

/// Variance of the order of layers inside a slice, which its sums do not tell, for a transmittance
/// difference of one.
const float kUnknownOrder = 0.003;
#endif

/// What a network makes of a prediction: by how much it multiplies errors at the ends of slices, and the
/// variance of the order of layers that slices do not tell.
struct Correction {
  vec4 error;  // of keeping what lies before each knot: every second slice
  vec4 order;  // inside the slices from each knot on
};

/// Fragments of a pixel from its nearest on.
struct Prefix {
  float fragments;
  float tau;
  float passes;  // transmittance
  vec3 tauColor;
  vec3 color;  // of its layers over nothing
};

const Prefix kNothing = Prefix(0.0, 0.0, 1.0, vec3(0.0), vec3(0.0));

/// A slice, or a part of one, with what follows from its sums.
struct Layer {
  float fragments;
  float tau;
  float passes;
  vec3 tauColor;
  vec3 color;  // opaque
};

Layer layerOf(Slice s, int parts) {
  float share = 1.0 / float(parts);
  return Layer(s.fragments * share, s.tau * share, exp2(-s.tau * share), s.tauColor * share,
               s.tauColor * (1.0 / max(s.tau, 1e-6)));
}

void extend(inout Prefix prefix, Layer layer) {
  float passes = prefix.passes * layer.passes;
  prefix.fragments += layer.fragments;
  prefix.tau += layer.tau;
  prefix.tauColor += layer.tauColor;
  prefix.color += (prefix.passes - passes) * layer.color;
  prefix.passes = passes;
}

#ifdef BID_ERROR
/// Squared error of keeping the prefix alone, behind it the mean of the rest where there is a tail.
/// @param slice the last one kept, as far as `part` of it, 0..1
float predictedError(Prefix kept, Prefix all, vec3 exact, vec3 behind, Correction c, int slice,
                     float part) {
#ifdef TAIL_IN_SLOT
  float left = 1.0 / max(all.tau - kept.tau, 1e-6);
  vec3 mean = max(all.tauColor - kept.tauColor, 0.0) * left;
  vec3 color = kept.color + (kept.passes - all.passes) * mean + all.passes * behind;
#else
  vec3 color = kept.color + kept.passes * behind;
#endif
  vec3 off = exact - shown(color);
  float unknown = kept.passes - all.passes;
#ifdef BID_LEARNED
  int knot = slice / LEARNED_SLICES_A_KNOT;
  float beyond = (float(slice % LEARNED_SLICES_A_KNOT) + part) / float(LEARNED_SLICES_A_KNOT);
  float more = mix(c.error[knot], c.error[min(knot + 1, LEARNED_KNOTS - 1)], beyond);
  return more * (dot(off, off) + c.order[knot] * unknown * unknown);
#else
  return dot(off, off) + kUnknownOrder * unknown * unknown;
#endif
}
#endif

/// @param behind radiance of the opaque surface · @param weight of the pixel's error
Bids bid(ivec2 p, uint n, vec4 prices[BID_VECTORS], vec3 behind, float weight, Correction correction) {
  Bids bids;
  for (int v = 0; v < BID_VECTORS; ++v) bids.slots[v] = vec4(n);
  if (n <= LEAST_SLOTS) return bids;
  uint base = sliceBase(p);
  Prefix all = kNothing;
  for (int i = 0; i < SLICES; ++i) {
    uvec4 words = slices[base + uint(i)];
    if (words.x != 0u) extend(all, layerOf(decodeSlice(words), 1));
  }
  // A tile's slices stand for all of its pixels, whatever their counts.
  float scale = float(n) / max(all.fragments, 1.0);
  Prefix kept = kNothing;
  float slots = slotsFor(0.0, n);
#ifdef BID_ERROR
  vec3 exact = shown(all.color + all.passes * behind);
  float value = weight * predictedError(kept, all, exact, behind, correction, 0, 0.0);
  vec4 each[BID_VECTORS];
  vec4 best[BID_VECTORS];
  for (int v = 0; v < BID_VECTORS; ++v) {
    each[v] = exp2(prices[v]);
    best[v] = float(n) * each[v];  // everything kept: no error
    vec4 cost = value + slots * each[v];
    bvec4 cheaper = lessThanEqual(cost, best[v]);
    bids.slots[v] = mix(bids.slots[v], vec4(slots), cheaper);
    best[v] = min(best[v], cost);
  }
#endif
  for (int i = 0; i < SLICES; ++i) {
    uvec4 words = slices[base + uint(i)];
    if (words.x == 0u) continue;
    Layer one = layerOf(decodeSlice(words), BID_PARTS);
    for (int j = 0; j < BID_PARTS; ++j) {
#ifdef BID_TRANSMITTANCE
      float tauBefore = kept.tau;
      float slotsBefore = slots;
#endif
      extend(kept, one);
      slots = slotsFor(kept.fragments * scale, n);
#ifdef BID_ERROR
      float part = float(j + 1) / float(BID_PARTS);
      value = weight * predictedError(kept, all, exact, behind, correction, i, part);
      for (int v = 0; v < BID_VECTORS; ++v) {
        vec4 cost = value + slots * each[v];
        bids.slots[v] = mix(bids.slots[v], vec4(slots), lessThan(cost, best[v]));
        best[v] = min(best[v], cost);
      }
#else
      // Where less than the price passes from here on: between the two, as if evenly deep.
      for (int v = 0; v < BID_VECTORS; ++v) {
        vec4 share = clamp((-prices[v] - tauBefore) / max(one.tau, 1e-6), 0.0, 1.0);
        bvec4 here = greaterThanEqual(-prices[v], vec4(tauBefore));
        bids.slots[v] = mix(bids.slots[v], ceil(mix(vec4(slotsBefore), vec4(slots), share)), here);
      }
#endif
    }
  }
#ifdef BID_TRANSMITTANCE
  for (int v = 0; v < BID_VECTORS; ++v) {
    bids.slots[v] = mix(bids.slots[v], vec4(slotsFor(0.0, n)), lessThan(-prices[v], vec4(0.0)));
    bids.slots[v] = mix(bids.slots[v], vec4(n), greaterThanEqual(-prices[v], vec4(all.tau)));
  }
#endif
  for (int v = 0; v < BID_VECTORS; ++v) {
    bids.slots[v] = clamp(bids.slots[v], vec4(LEAST_SLOTS), vec4(n));
  }
  return bids;
}
#else
Bids bid(uint n, vec4 prices[BID_VECTORS], float importance) {
  Bids bids;
  float least = float(min(n, LEAST_SLOTS));
  for (int v = 0; v < BID_VECTORS; ++v) {
    bids.slots[v] = clamp(floor(importance * exp2(-prices[v])), vec4(least), vec4(n));
  }
  return bids;
}
#endif
