// Depth slices: the fragments of a pixel, or of a tile of pixels, summed in each of a few intervals of
// distance. Fixed point, so that their order changes nothing.
// SLICES: how many. SLICE_TILE: samples a side that share them. Both are constants: where integers are
// divided in software, uniforms took a tenth of the pass that sums.
#include "lib/frame.glsl"
#include "shared/oit_constants.h"

struct Slice {
  float fragments;
  float tau;      // optical depth, halvings
  vec3 tauColor;  // optical depth times colour
};

/// Words of a slice: count above optical depth in one, then colour. Beyond their range they wrap, which
/// makes the prediction worse and nothing else.
uvec4 encodeSlice(float tau, vec3 color) {
  uvec4 fixedPoint = uvec4(vec4(tau, tau * color) * SLICE_STEPS + 0.5);
  return uvec4(fixedPoint.x + (1u << SLICE_COUNT_SHIFT), fixedPoint.yzw);
}

Slice decodeSlice(uvec4 words) {
  Slice s;
  s.fragments = float(words.x >> SLICE_COUNT_SHIFT);
  s.tau = float(words.x & ((1u << SLICE_COUNT_SHIFT) - 1u)) / SLICE_STEPS;
  s.tauColor = vec3(words.yzw) / SLICE_STEPS;
  return s;
}

/// First slice of the tile that holds a pixel.
uint sliceBase(ivec2 p) {
  uvec2 tile = uvec2(p) / uint(SLICE_TILE);
  uint tilesWide = (uint(frame.size.x) + uint(SLICE_TILE) - 1u) / uint(SLICE_TILE);
  return (tile.y * tilesWide + tile.x) * uint(SLICES);
}

/// About what a display shows of a radiance: gamma 2 in place of sRGB. Predicted errors are measured in
/// it.
vec3 displayed(vec3 radiance) { return sqrt(clamp(radiance, 0.0, 1.0)); }
