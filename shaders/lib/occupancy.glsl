// Depth intervals of a pixel, from its nearest to its farthest transparent fragment: 32 of them to a
// word of its map. Equal steps of the depth's bits: finer where it is near, and whole numbers.
// RANGES: slots from the table.
#include "lib/frame.glsl"
#include "lib/oit.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(binding = TEX_INPUT1) uniform sampler2D depthRange;
#ifdef RANGES
layout(rg32ui, binding = IMG_0) readonly uniform uimage2D fragmentRange;
#endif
layout(std430, binding = SSBO_OCCUPANCY) buffer Occupancy { uint occupancy[]; };

struct DepthIntervals {
  uint nearest;  // bits of the nearest depth
  float perBit;  // intervals in one step of the bits
};

/// Slots of a pixel that has more fragments than those; 0 where all of them fit.
uint slotsIfCrowded(ivec2 p) {
#ifdef RANGES
  uint k = slotsOf(imageLoad(fragmentRange, p).rg).capacity;
#else
  uint k = frame.oit.x;
#endif
  return texelFetch(fragmentCount, p, 0).r > float(k) ? k : 0u;
}

DepthIntervals intervalsAt(ivec2 p) {
  vec2 range = texelFetch(depthRange, p, 0).rg;
  uint nearest = floatBitsToUint(range.x);
  uint farthest = floatBitsToUint(-range.y);
  return DepthIntervals(nearest, float(32u * frame.oit.w) / float(nearest - farthest + 1u));
}

/// The same for the same depth wherever it is asked, and never falling as depth grows.
uint intervalOf(DepthIntervals d, uint depthBits) {
  return min(uint(float(d.nearest - depthBits) * d.perBit), 32u * frame.oit.w - 1u);
}

uint firstWord(ivec2 p) { return uint(p.y * int(frame.size.x) + p.x) * frame.oit.w; }
