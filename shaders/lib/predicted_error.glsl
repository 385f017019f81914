// Error of keeping only a pixel's nearest fragments, predicted from its depth slices.
//
// Fragments lie in layers 1..m from the eye: slices, or even parts of slices. C_j is the colour of the
// first j layers over nothing, T_j their transmittance, B the radiance of the opaque surface. Keeping j
// layers shows, with a tail (lib/oit.glsl) and without one,
//   K_j = C_j + (T_j - T_m) mean_j + T_m B     mean_j = sum_{i>j} tau_i c_i / sum_{i>j} tau_i
//   K_j = C_j + T_j B
// and its predicted squared error is
//   E_j = |D(C_m + T_m B) - D(K_j)|^2 + v (T_j - T_m)^2
// with D what a display shows and v the variance that comes from the order of the fragments inside a
// layer, which sums do not tell. UTILITY_LEARNED: a network scales both terms.
// TAIL_IN_SLOT: what is not kept is merged in a tail.
#include "lib/slices.glsl"
#include "shared/network.h"

/// v. One constant for all scenes; a network replaces it.
const float kUnknownOrder = 0.003;

/// A network's correction of a prediction. All 0 in its output makes the plain prediction.
struct Correction {
  vec4 error;  // factor of E_j at each knot: before every second slice
  vec4 order;  // v inside the slices from each knot on
};

/// Fragments of a pixel from its nearest on.
struct Prefix {
  float fragments;
  float tau;
  float transmittance;
  vec3 tauColor;
  vec3 color;  // of its layers over nothing
};

const Prefix kNothing = Prefix(0.0, 0.0, 1.0, vec3(0.0), vec3(0.0));

/// A slice or a part of one.
struct Layer {
  float fragments;
  float tau;
  float transmittance;
  vec3 tauColor;
  vec3 color;  // as if opaque
};

/// One of `parts` even parts of a slice.
Layer layerOf(Slice s, int parts) {
  float share = 1.0 / float(parts);
  return Layer(s.fragments * share, s.tau * share, exp2(-s.tau * share), s.tauColor * share,
               s.tauColor * (1.0 / max(s.tau, 1e-6)));
}

/// Puts a layer behind a prefix.
void extend(inout Prefix prefix, Layer layer) {
  float transmittance = prefix.transmittance * layer.transmittance;
  prefix.fragments += layer.fragments;
  prefix.tau += layer.tau;
  prefix.tauColor += layer.tauColor;
  prefix.color += (prefix.transmittance - transmittance) * layer.color;
  prefix.transmittance = transmittance;
}

#ifdef UTILITY_ERROR
/// E_j. @param exact D(C_m + T_m B) · @param slice the last one kept, as far as `part` of it, 0..1
float predictedError(Prefix kept, Prefix all, vec3 exact, vec3 behind, Correction c, int slice,
                     float part) {
#ifdef TAIL_IN_SLOT
  float left = 1.0 / max(all.tau - kept.tau, 1e-6);
  vec3 mean = max(all.tauColor - kept.tauColor, 0.0) * left;
  vec3 color = kept.color + (kept.transmittance - all.transmittance) * mean + all.transmittance * behind;
#else
  vec3 color = kept.color + kept.transmittance * behind;
#endif
  vec3 off = exact - displayed(color);
  float unknown = kept.transmittance - all.transmittance;
#ifdef UTILITY_LEARNED
  int knot = slice / LEARNED_SLICES_A_KNOT;
  float beyond = (float(slice % LEARNED_SLICES_A_KNOT) + part) / float(LEARNED_SLICES_A_KNOT);
  float factor = mix(c.error[knot], c.error[min(knot + 1, LEARNED_KNOTS - 1)], beyond);
  return factor * (dot(off, off) + c.order[knot] * unknown * unknown);
#else
  return dot(off, off) + kUnknownOrder * unknown * unknown;
#endif
}
#endif
