// Stores transparent fragments in their pixel's slots.
// INSERTION_APPEND: in any order, sorted at the resolve. INSERTION_LINKED: the same, as a list.
// INSERTION_SORTED: the nearest, in order. TAIL_IN_SLOT: the others are summed in a tail behind them.
// TAIL_DYNAMIC: the tail begins when the slots are full, because the number of fragments was not known.
// INSERTION_ATOMIC: keys were stored before (oit/atomic_keys.frag); each colour goes to its key.
// TAIL_DENSE: the others are summed by blending.
// Per-pixel ordering: SYNC_ORDERED: the rasteriser draws a pixel's fragments in order on one thread.
// SYNC_INTERLOCK, SYNC_SPINLOCK: mutual exclusion. SYNC_NONE: hazards on purpose.
// COUNT_OUT: also counts fragments by blending, for the next frame.
#if defined(SYNC_INTERLOCK) && defined(INSERTION_SORTED)
layout(pixel_interlock_ordered) in;
#endif
layout(early_fragment_tests) in;

#define EXPLICIT_GRADIENTS
#include "shared/bindings.h"
#if defined(SYNC_ORDERED) || defined(SYNC_NONE) || defined(INSERTION_ATOMIC)
#define SHARED_MEMORY
#else
#define SHARED_MEMORY coherent
#endif
#define STORE_ACCESS SHARED_MEMORY
#include "lib/fragment_store.glsl"
#include "lib/transparent.glsl"

#ifdef RANGES
layout(rg32ui, binding = IMG_0) readonly uniform uimage2D fragmentRange;
#endif
#ifndef INSERTION_ATOMIC
layout(r32ui, binding = IMG_1) SHARED_MEMORY uniform uimage2D fragmentFill;
#endif
#ifdef FRONT_NORMAL
layout(rgba8_snorm, binding = IMG_2) writeonly uniform image2D frontNormal;
#endif
#ifdef SYNC_SPINLOCK
layout(r32ui, binding = IMG_3) coherent uniform uimage2D fragmentLock;
#endif
#ifdef INSERTION_LINKED
layout(std430, binding = SSBO_FRAGMENT_LINKS) buffer Links { uint links[]; };
#endif
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
#ifdef TAIL_DENSE
layout(location = 0) out vec4 tailOut;
#endif
#ifdef COUNT_OUT
layout(location = 0) out float countOut;
#endif

PixelSlots pixelSlots(ivec2 p) {
#ifdef RANGES
  return slotsOf(imageLoad(fragmentRange, p).rg);
#else
  return PixelSlots(uint(p.y * int(frame.size.x) + p.x) * frame.pixelSlots, frame.pixelSlots, false);
#endif
}

#ifdef INSERTION_SORTED
#include "lib/insert_sorted.glsl"
#endif

#if defined(INSERTION_APPEND)
void keep(ivec2 p, PixelSlots slots, uvec2 key) {
  if (slots.capacity == 0u) return;
  Fragment fragment = makeFragment(key, shadeTransparent());
#ifdef SYNC_ORDERED
  uint slot = imageLoad(fragmentFill, p).r;
  imageStore(fragmentFill, p, uvec4(slot + 1u));
#else
  uint slot = imageAtomicAdd(fragmentFill, p, 1u);
#endif
  if (slot >= slots.capacity) return;  // beyond the pool: counted, the frame is flagged inexact
  storeFragment(slots.first + slot, fragment);
}
#elif defined(INSERTION_LINKED)
/// fragmentFill holds the head of the pixel's list: the number of a link plus one; 0 ends a list.
void keep(ivec2 p, PixelSlots slots, uvec2 key) {
  uint link = atomicAdd(totals.cursor, 1u);
  if (link >= frame.slots) return;  // the pool is full: counted, the frame is flagged inexact
  storeFragment(link, makeFragment(key, shadeTransparent()));
#ifdef SYNC_ORDERED
  links[link] = imageLoad(fragmentFill, p).r;
  imageStore(fragmentFill, p, uvec4(link + 1u));
#else
  links[link] = imageAtomicExchange(fragmentFill, p, link + 1u);
#endif
}
#elif defined(INSERTION_ATOMIC)
void keep(ivec2 p, PixelSlots slots, uvec2 key) {
  bool kept = !isNearer(keys[slots.first + slots.capacity - 1u], key);
#ifndef TAIL_DENSE
  if (!kept) return;
#endif
  vec4 color = shadeTransparent();
  Fragment fragment = makeFragment(key, color);
  for (uint i = 0u; kept && i < slots.capacity; ++i) {
    if (keys[slots.first + i] == key) {
      colors[slots.first + i] = fragment.color;
      break;
    }
  }
#ifdef TAIL_DENSE
  tailOut = kept ? vec4(0.0) : tailAddend(color);
#endif
}
#endif

void main() {
#ifdef HOLED
  // No discard: the interlock must begin outside of all branches.
  bool there = isThere();
#else
  const bool there = true;
#ifdef TEXTURED
  prepareGradients();
#endif
#endif
  ivec2 p = ivec2(gl_FragCoord.xy);
  PixelSlots slots = pixelSlots(p);
  uvec2 key = fragmentKey(gl_FragCoord.z, fragmentId());
#ifdef COUNT_OUT
  countOut = there ? 1.0 : 0.0;
#endif
#ifndef INSERTION_SORTED
#if defined(TAIL_DENSE) && defined(HOLED)
  tailOut = vec4(0.0);
#endif
  if (there) keep(p, slots, key);
#else
  // No early return: the interlock must begin outside of all branches.
  uint fill = 0u;
  bool wanted = there && (slots.capacity > 0u || slots.tail);
#ifndef TAIL_IN_SLOT
  if (wanted) {
    fill = imageLoad(fragmentFill, p).r;
    wanted = !isRejected(slots, fill, key);
  }
#endif
  Fragment fragment;
  if (wanted) fragment = makeFragment(key, shadeTransparent());
#if defined(SYNC_INTERLOCK)
  beginInvocationInterlockARB();
  if (wanted) insertIfNearer(p, slots, fragment);
  endInvocationInterlockARB();
#elif defined(SYNC_SPINLOCK)
  bool done = !wanted || gl_HelperInvocation;  // helpers write nothing and must not wait
  for (int i = 0; i < LOCK_BOUND && !done; ++i) {
    if (imageAtomicExchange(fragmentLock, p, 1u) != 0u) continue;
    insertIfNearer(p, slots, fragment);
    memoryBarrier();
    imageAtomicExchange(fragmentLock, p, 0u);
    done = true;
  }
  if (!done) atomicAdd(totals.lockFailures, 1u);
#elif defined(TAIL_IN_SLOT) || defined(PACKED)
  // A packed fragment's place among equal depths is known only with its colour.
  if (wanted) insertIfNearer(p, slots, fragment);
#else
  if (wanted) insertSorted(p, slots, fill, fragment);
#endif
#endif
}
