// Inserts fragments by the text of the capture, each by a work group of its own, in such an order that
// groups meet in a pixel.
layout(local_size_x = 1) in;

#include "lib/hash.glsl"
#include "shared/bindings.h"
#define LOCK_WAITED atomicAdd(waits, 1u);
#include "lib/pixel_lock.glsl"
#define STORE_ACCESS SHARED_MEMORY
#include "lib/fragment_store.glsl"

layout(r32ui, binding = IMG_1) SHARED_MEMORY uniform uimage2D fragmentFill;
layout(rgba8_snorm, binding = IMG_2) SHARED_MEMORY writeonly uniform image2D frontNormal;
layout(r32ui, binding = IMG_3) coherent uniform uimage2D fragmentLock;
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
layout(std430, binding = SSBO_COVERED) buffer Waits { uint waits; };
layout(std430, binding = SSBO_SLICES) buffer Arrivals { uint arrivals[]; };  // of each pixel
layout(location = 0) uniform uvec2 size;
layout(location = 1) uniform uint fragments;  // of each pixel
layout(location = 2) uniform uint slotsEach;
layout(location = 3) uniform uint seed;
// A software device gives each of its threads as long a run of groups: the runs go over the same
// pixels. 1: a pixel's groups follow each other, which GPUs start together.
layout(location = 4) uniform uint runs;

uint pixel;
uint number;  // of the fragment, in its pixel

#define FRONT_NORMAL
vec3 frontNormalOfFragment() { return vec3(float(number) / 127.0); }
#include "lib/insert_sorted.glsl"

/// The first fragments of all runs wait for each other, for a while.
void meet() {
  const int kPatience = 4096;
  atomicAdd(arrivals[pixel], 1u);
  for (int i = 0; i < kPatience && atomicAdd(arrivals[pixel], 0u) < runs; ++i) {
  }
}

void main() {
  uint each = fragments / runs;
  uint place = gl_WorkGroupID.x % (gl_NumWorkGroups.x / runs);
  uint run = gl_WorkGroupID.x / (gl_NumWorkGroups.x / runs);
  pixel = place / each;
  number = run * each + place % each;
  if (place % each == 0u) meet();

  ivec2 p = ivec2(pixel % size.x, pixel / size.x);
  uint first = pixel * slotsEach;
#if defined(TAIL_IN_SLOT) && !defined(TAIL_DYNAMIC)
  PixelSlots slots = PixelSlots(first, slotsEach - TAIL_SLOTS, true);
#else
  PixelSlots slots = PixelSlots(first, slotsEach, false);
#endif
  // So few depths that some are equal. The same on the CPU: contention_test.cpp.
  uint random = hashPcg(seed ^ pixel * 128u ^ number);
  uvec2 key = fragmentKey(float(1u + random % 64u) / 64.0, number);
  bool wanted = slots.capacity > 0u || slots.tail;
#ifndef TAIL_IN_SLOT
  wanted = wanted && !isRejected(p, slots, key);
#endif
  // Both storages hold these colours as they are.
  Fragment fragment = makeFragment(key, vec4(float(number) / 256.0, 0.0, 1.0, 1.0) * 0.5);
  EXCLUSIVELY(p, wanted, insertIfNearer(p, slots, fragment))
}
