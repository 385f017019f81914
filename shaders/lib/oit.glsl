// What the transparency passes share: keys, slots, tails, optical depth.
//
// A pixel's fragments are split as in the literature on hybrid transparency (Maule et al. 2013): the
// core, the nearest fragments, each in a slot of its own; and the tail, all others behind them, merged
// into one layer whose colour is their mean weighted by optical depth and whose transmittance is exact.
// A tail stores (sum of tau c, sum of tau), tau = -log2(1 - alpha).
#ifndef MACULA_OIT_GLSL
#define MACULA_OIT_GLSL
#include "lib/half.glsl"
#include "shared/bindings.h"
#include "shared/oit_constants.h"
#include "shared/oit_totals.h"

/// Sorts ascending from the eye: reversed depth is a positive float, whose bits order like the
/// value, so the complement puts the nearest first. Ties go to the lower id.
uvec2 fragmentKey(float reversedDepth, uint id) { return uvec2(~floatBitsToUint(reversedDepth), id); }

bool isNearer(uvec2 a, uvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// Optical depth: transmittance = 2^-tau. Bounded, so that an opaque layer stays finite.
float opticalDepth(float alpha) {
  return min(MAX_OPTICAL_DEPTH, -log2(max(1.0 - alpha, exp2(-MAX_OPTICAL_DEPTH))));
}

/// A premultiplied fragment as an addend of a tail, rounded so that sums below 1,024 hold every bit and
/// do not depend on their order.
vec4 tailAddend(vec4 premultiplied) {
  float alpha = clamp(premultiplied.a, 0.0, 1.0);
  if (alpha <= 0.0) return vec4(0.0);  // an empty layer has no colour to average
  float tau = opticalDepth(alpha);
  return round(vec4(premultiplied.rgb / alpha, 1.0) * tau * TAIL_STEPS) / TAIL_STEPS;
}

/// The layer that stands for a tail, premultiplied.
vec4 tailLayer(vec4 sum) {
  if (sum.a <= 0.0) return vec4(0.0);
  float alpha = 1.0 - exp2(-sum.a);
  return vec4(sum.rgb / sum.a * alpha, alpha);
}

/// Slots of a pixel.
struct PixelSlots {
  uint first;     // of the pool
  uint capacity;  // slots of the core
  bool tail;      // TAIL_SLOTS behind them hold a tail
};

#ifdef PACKED
#define TAIL_SLOTS 2u  // its four sums take 16 bytes
#else
#define TAIL_SLOTS 1u
#endif

/// Slots without which a pixel would lose all of its fragments.
#ifdef TAIL_IN_SLOT
#define LEAST_SLOTS TAIL_SLOTS
#else
#define LEAST_SLOTS 1u
#endif

/// Whether a pixel of n fragments with k slots needs and can hold a tail.
bool hasTail(uint n, uint k) {
#if defined(TAIL_IN_SLOT) && !defined(TAIL_DYNAMIC)
  return n > k && k >= TAIL_SLOTS;
#else
  return false;
#endif
}

/// Slots in use, by a word of fragmentFill of sorted insertion (lib/insert_sorted.glsl).
uint storedFragments(uint word, PixelSlots slots) { return min(word & ~RANGE_TAIL, slots.capacity); }

/// Slots that a pixel demands at a high and at a low multiplier (lib/demand.glsl), as one word.
uint packDemand(vec2 slots) { return uint(slots.x) | max(uint(slots.x), uint(slots.y)) << 16; }
uvec2 unpackDemand(uint word) { return uvec2(word & 0xFFFFu, word >> 16); }

#ifdef RANGES
PixelSlots slotsOf(uvec2 range) {
  return PixelSlots(range.x, range.y & ~RANGE_TAIL, (range.y & RANGE_TAIL) != 0u);
}
#endif
#endif
