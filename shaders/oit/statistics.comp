// Sums for the report, after a frame, what became of its fragments.
// SLOTS_RANGES: slots are those of fragmentRange; otherwise the same for all pixels. FILLS: slots in use
// were counted.
#include "lib/tile.glsl"

#include "lib/frame.glsl"
#define RANGES
#include "lib/oit.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(binding = TEX_INPUT1) uniform usampler2D fragmentRange;
layout(binding = TEX_INPUT2) uniform usampler2D fragmentFill;
layout(std430, binding = SSBO_OIT_STATISTICS) buffer Statistics { OitStatistics statistics; };
layout(location = 0) uniform uint tailOfConstant;  // slots of a tail where n exceeds the slots

void main() {
  OitStatistics s = OitStatistics(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
  ivec2 p = firstPlace();
  int places = placesInside(p, ivec2(frame.size));
  for (int i = 0; i < places; ++i, p += kPlaceStep) {
    uint n = uint(texelFetch(fragmentCount, p, 0).r);
    if (n == 0u) continue;
#ifdef SLOTS_RANGES
    PixelSlots slots = slotsOf(texelFetch(fragmentRange, p, 0).rg);
#else
    PixelSlots slots = PixelSlots(0u, frame.pixelSlots, false);
#endif
#ifdef FILLS
    uint stored = texelFetch(fragmentFill, p, 0).r;
    bool tail = slots.tail || (stored & RANGE_TAIL) != 0u;
    uint k = slots.capacity + (slots.tail ? tailOfConstant : 0u);
    stored = min(stored & ~RANGE_TAIL, slots.capacity);
#else
    bool tail = n > slots.capacity && tailOfConstant > 0u;
    uint k = slots.capacity;
    uint stored = min(n, k);
#endif
    s.generated += n;
    s.stored += stored;
    if (tail) {
      s.merged += n - stored;
      ++s.tails;
    }
    s.slots += k;
    ++s.covered;
    s.countMax = max(s.countMax, n);
    s.kMax = max(s.kMax, k);
    s.kMinInverted = max(s.kMinInverted, ~k);
  }
  uvec4 fragments = groupTotal(uvec4(s.generated, s.stored, s.merged, s.tails), bvec4(false));
  uvec2 pixels = groupTotal(uvec4(s.slots, s.covered, 0u, 0u), bvec4(false)).xy;
  uvec3 most = groupTotal(uvec4(s.countMax, s.kMax, s.kMinInverted, 0u), bvec4(true)).xyz;
  if (!addsForGroup() || pixels.y == 0u) return;
  atomicAdd(statistics.generated, fragments.x);
  atomicAdd(statistics.stored, fragments.y);
  atomicAdd(statistics.merged, fragments.z);
  atomicAdd(statistics.tails, fragments.w);
  atomicAdd(statistics.slots, pixels.x);
  atomicAdd(statistics.covered, pixels.y);
  atomicMax(statistics.countMax, most.x);
  atomicMax(statistics.kMax, most.y);
  atomicMax(statistics.kMinInverted, most.z);
}
