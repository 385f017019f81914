// Sums for the report, after a frame, what became of its fragments.
// SLOTS_RANGES: slots are those of fragmentRange; otherwise the same for all pixels. FILLS: slots in use
// were counted.
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/frame.glsl"
#define RANGES
#include "lib/oit.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(binding = TEX_INPUT1) uniform usampler2D fragmentRange;
layout(binding = TEX_INPUT2) uniform usampler2D fragmentFill;
layout(std430, binding = SSBO_OIT_STATISTICS) buffer Statistics { OitStatistics statistics; };
layout(location = 0) uniform uint tailOfConstant;  // slots of a tail where n exceeds the slots

void main() {
  ivec2 first = ivec2(int(gl_GlobalInvocationID.x) * STRIP, int(gl_WorkGroupID.y));
  int end = min(first.x + STRIP, int(frame.size.x));
  OitStatistics s = OitStatistics(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
  for (ivec2 p = first; p.x < end; ++p.x) {
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
  if (s.covered == 0u) return;
  atomicAdd(statistics.generated, s.generated);
  atomicAdd(statistics.stored, s.stored);
  atomicAdd(statistics.merged, s.merged);
  atomicAdd(statistics.tails, s.tails);
  atomicAdd(statistics.slots, s.slots);
  atomicAdd(statistics.covered, s.covered);
  atomicMax(statistics.countMax, s.countMax);
  atomicMax(statistics.kMax, s.kMax);
  atomicMax(statistics.kMinInverted, s.kMinInverted);
}
