// What the transparency passes share: keys, ranges, optical depth.
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

/// Optical depth in halvings of what passes. Bounded, so that an opaque layer stays finite.
float opticalDepth(float alpha) {
  return min(MAX_OPTICAL_DEPTH, -log2(max(1.0 - alpha, exp2(-MAX_OPTICAL_DEPTH))));
}

/// A premultiplied fragment as an addend of a tail: (tau c, tau), rounded so that sums below 1,024
/// hold every bit and do not depend on their order.
vec4 tailAddend(vec4 premultiplied) {
  float alpha = clamp(premultiplied.a, 0.0, 1.0);
  if (alpha <= 0.0) return vec4(0.0);  // an empty layer has no colour to average
  float tau = opticalDepth(alpha);
  return round(vec4(premultiplied.rgb / alpha, 1.0) * tau * TAIL_STEPS) / TAIL_STEPS;
}

/// One layer for all of a tail: mean colour weighted by optical depth, exact transmittance.
vec4 tailLayer(vec4 sum) {
  if (sum.a <= 0.0) return vec4(0.0);
  float alpha = 1.0 - exp2(-sum.a);
  return vec4(sum.rgb / sum.a * alpha, alpha);
}

/// Slots of a pixel: x first, y how many hold single fragments, z those of a tail behind them.
struct PixelSlots {
  uint first;
  uint capacity;
  bool tail;
};

#ifdef PACKED
#define TAIL_SLOTS 2u  // its four sums take 16 bytes
#else
#define TAIL_SLOTS 1u
#endif

/// Slots without which something of a pixel would not be seen at all.
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

/// Slots that a pixel takes at a high and at a low price, as one word.
uint packTaken(vec2 taken) { return uint(taken.x) | max(uint(taken.x), uint(taken.y)) << 16; }
uvec2 unpackTaken(uint word) { return uvec2(word & 0xFFFFu, word >> 16); }

#ifdef RANGES
PixelSlots slotsOf(uvec2 range) {
  return PixelSlots(range.x, range.y & ~RANGE_TAIL, (range.y & RANGE_TAIL) != 0u);
}
#endif
#endif
