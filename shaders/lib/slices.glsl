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

const uint kSliceDepthBits = (1u << SLICE_COUNT_SHIFT) - 1u;
const uint kSliceColorBits = (1u << SLICE_CARRY_SHIFT) - 1u;

/// A fragment as addend of the words of a slice: count above optical depth in one, then colour.
uvec4 encodeSlice(float tau, vec3 color) {
  uvec4 fixedPoint = uvec4(vec4(tau, tau * color) * SLICE_STEPS + 0.5);
  return uvec4(fixedPoint.x + (1u << SLICE_COUNT_SHIFT), fixedPoint.yzw);
}

/// Where adding the first word makes the count or the optical depth run over, the addend that notes it:
/// above red for the count, above green for the optical depth, which runs over into the count. Each is
/// noted by one fragment, whatever their order. @param before the first word before the addition
uvec4 withCarry(uvec4 addend, uint before) {
  uint depth = (before & kSliceDepthBits) + (addend.x & kSliceDepthBits);
  if (before + addend.x < before) addend.y += 1u << SLICE_CARRY_SHIFT;
  if (depth > kSliceDepthBits) addend.z += 1u << SLICE_CARRY_SHIFT;
  return addend;
}

/// Whether no fragment is in a slice.
bool isEmptySlice(uvec4 words) { return (words.x | words.y) == 0u; }

Slice decodeSlice(uvec4 words) {
  uvec2 carries = words.yz >> SLICE_CARRY_SHIFT;
  uint depth = (words.x & kSliceDepthBits) + (carries.y << SLICE_COUNT_SHIFT);
  uint count = (words.x >> SLICE_COUNT_SHIFT) + (carries.x << (32 - SLICE_COUNT_SHIFT)) - carries.y;
  Slice s;
  s.fragments = float(count);
  s.tau = float(depth) / SLICE_STEPS;
  s.tauColor = vec3(words.y & kSliceColorBits, words.z & kSliceColorBits, words.w) / SLICE_STEPS;
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
