// Depth intervals of a pixel between its nearest and its farthest transparent fragment (Vasilakis 2015,
// section 2): 32 of them to a word of its bit map. They are equal steps of the depth's bits, so that near
// intervals are finer and the arithmetic is exact in integers.
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

/// Slots of a pixel that has more fragments than slots; 0 where all of them fit.
uint slotsIfCrowded(ivec2 p) {
#ifdef RANGES
  uint k = slotsOf(imageLoad(fragmentRange, p).rg).capacity;
#else
  uint k = frame.pixelSlots;
#endif
  return texelFetch(fragmentCount, p, 0).r > float(k) ? k : 0u;
}

DepthIntervals intervalsAt(ivec2 p) {
  vec2 range = texelFetch(depthRange, p, 0).rg;
  uint nearest = floatBitsToUint(range.x);
  uint farthest = floatBitsToUint(-range.y);
  return DepthIntervals(nearest, float(32u * frame.occupancyWords) / float(nearest - farthest + 1u));
}

/// Deterministic in the depth, and never falling as depth grows.
uint intervalOf(DepthIntervals d, uint depthBits) {
  return min(uint(float(d.nearest - depthBits) * d.perBit), 32u * frame.occupancyWords - 1u);
}

uint firstWord(ivec2 p) { return uint(p.y * int(frame.size.x) + p.x) * frame.occupancyWords; }
