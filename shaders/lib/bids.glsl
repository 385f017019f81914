// What a pixel would pay for its slots. Each further slot has a price that the pixel is ready to pay,
// lower than that of the one before; at one price for the whole image every pixel takes the slots
// that are worth it, and the budget decides the price.
// BID_UNIFORM: 1 / k. BID_IMPORTANCE: I / k, so that k follows importance (D'Hondt's method with the
// pixel's fragments as a cap). BID_TRANSMITTANCE: what passes the slots before. BID_ERROR: how much
// the predicted squared error falls.
// PACKED, TAIL_IN_SLOT: as for the capture.
#include "lib/oit.glsl"
#include "lib/importance.glsl"

#if defined(BID_TRANSMITTANCE) || defined(BID_ERROR)
#include "lib/slices.glsl"
#define KNOTS (MAX_SLICES * SLICE_PARTS + 1)
layout(std430, binding = SSBO_SLICES) readonly buffer Slices { uvec4 slices[]; };
#endif

struct Bidder {
  uint n;      // fragments
  uint least;  // slots without which something of the pixel is not seen at all
#if defined(BID_TRANSMITTANCE) || defined(BID_ERROR)
  int knots;
  float slots[KNOTS];
  float value[KNOTS];  // log2 of what passes, or predicted squared error, with these slots
#else
  float importance;
#endif
};

uint leastSlots(uint n) { return min(n, LEAST_SLOTS); }

/// Slots for so many single fragments and, unless these are all, a tail.
float slotsFor(float fragments, uint n) {
#ifdef TAIL_IN_SLOT
  return min(ceil(fragments) + float(TAIL_SLOTS), float(n));
#else
  return clamp(ceil(fragments), 1.0, float(n));
#endif
}

#ifdef BID_ERROR
/// About what a display shows of a radiance: gamma 2 in place of sRGB.
vec3 shown(vec3 radiance) { return sqrt(clamp(radiance, 0.0, 1.0)); }

/// Variance of the order of layers inside a slice, which its sums do not tell, for a transmittance
/// difference of one.
const float kUnknownOrder = 0.003;
#endif

#if defined(BID_TRANSMITTANCE) || defined(BID_ERROR)
/// @param behind radiance of the opaque surface
Bidder makeBidder(ivec2 p, uint n, vec3 behind, float weight) {
  Bidder b;
  b.n = n;
  b.least = leastSlots(n);
  b.knots = 0;
  if (n <= b.least) return b;
  uint base = sliceBase(p);
  int count = int(frame.slices.z);
  Slice all = Slice(0.0, 0.0, vec3(0.0));
  vec3 whole = vec3(0.0);
  float passes = 1.0;
  for (int i = 0; i < count; ++i) {
    Slice s = decodeSlice(slices[base + uint(i)]);
    if (s.fragments == 0.0) continue;
    float through = exp2(-s.tau);
    whole += passes * (1.0 - through) * s.tauColor / max(s.tau, 1e-6);
    passes *= through;
    all.fragments += s.fragments;
    all.tau += s.tau;
    all.tauColor += s.tauColor;
  }
  // A tile's slices stand for all of its pixels, whatever their counts.
  float scale = float(n) / max(all.fragments, 1.0);
#ifdef BID_ERROR
  vec3 exact = shown(whole + passes * behind);
  vec3 front = vec3(0.0);
#endif
  Slice kept = Slice(0.0, 0.0, vec3(0.0));
  for (int i = -1; i < count; ++i) {
    Slice part = Slice(0.0, 0.0, vec3(0.0));
    if (i >= 0) {
      part = decodeSlice(slices[base + uint(i)]);
      if (part.fragments == 0.0) continue;
      part.fragments /= float(SLICE_PARTS);
      part.tau /= float(SLICE_PARTS);
      part.tauColor /= float(SLICE_PARTS);
    }
    float through = exp2(-part.tau);
    vec3 color = (1.0 - through) * part.tauColor / max(part.tau, 1e-6);
    for (int j = 0; j < (i < 0 ? 1 : SLICE_PARTS); ++j) {
      float before = exp2(-kept.tau);
#ifdef BID_ERROR
      front += before * color;
#endif
      kept.fragments += part.fragments;
      kept.tau += part.tau;
      kept.tauColor += part.tauColor;
      b.slots[b.knots] = slotsFor(kept.fragments * scale, n);
#ifdef BID_ERROR
      float reaches = exp2(-kept.tau);
#ifdef TAIL_IN_SLOT
      float tauLeft = max(all.tau - kept.tau, 0.0);
      vec3 mean = max(all.tauColor - kept.tauColor, 0.0) / max(tauLeft, 1e-6);
      vec3 left = mix(mean, behind, exp2(-tauLeft));
#else
      vec3 left = behind;
#endif
      vec3 off = exact - shown(front + reaches * left);
      float unknown = reaches - passes;
      b.value[b.knots] = weight * (dot(off, off) + kUnknownOrder * unknown * unknown);
#else
      b.value[b.knots] = -kept.tau;
#endif
      ++b.knots;
    }
  }
  return b;
}

/// @param price log2
uint slotsAt(Bidder b, float price) {
  if (b.n <= b.least) return b.n;
#ifdef BID_ERROR
  float each = exp2(price);
  float best = float(b.n) * each;  // everything kept: no error
  float taken = float(b.n);
  for (int i = 0; i < b.knots; ++i) {
    float cost = b.value[i] + b.slots[i] * each;
    if (cost < best || (cost == best && b.slots[i] < taken)) {
      best = cost;
      taken = b.slots[i];
    }
  }
  return clamp(uint(taken), b.least, b.n);
#else
  // The first fragments after which less passes than the price, between knots as if evenly deep.
  float slots = b.slots[0];
  for (int i = 1; i < b.knots; ++i) {
    if (b.value[i - 1] < price) break;
    float share = clamp((b.value[i - 1] - price) / max(b.value[i - 1] - b.value[i], 1e-6), 0.0, 1.0);
    slots = mix(b.slots[i - 1], b.slots[i], share);
  }
  if (b.value[b.knots - 1] >= price) slots = float(b.n);
  return clamp(uint(ceil(slots)), b.least, b.n);
#endif
}
#else
Bidder makeBidder(uint n, float importance) { return Bidder(n, leastSlots(n), importance); }

/// @param price log2
uint slotsAt(Bidder b, float price) {
  float slots = floor(b.importance * exp2(-price));
  return uint(clamp(slots, float(b.least), float(b.n)));
}
#endif
