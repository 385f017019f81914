// Stores transparent fragments in their pixel's slots.
// INSERTION_APPEND: in any order, sorted at the resolve. INSERTION_LINKED: the same, as a list.
// INSERTION_SORTED: the nearest, in order. TAIL_IN_SLOT: the others are summed in a tail behind them.
// TAIL_DYNAMIC: the tail begins when the slots are full, because the number of fragments was not known.
// INSERTION_ATOMIC: keys were stored before (oit/atomic_keys.frag); each colour goes to its key.
// TAIL_DENSE: the others are summed by blending.
// SYNC_...: how a pixel's insertions exclude each other, see lib/pixel_lock.glsl.
// COUNT_OUT: also counts fragments by blending, for the next frame.
#if defined(SYNC_INTERLOCK) && defined(INSERTION_SORTED)
layout(pixel_interlock_unordered) in;
#endif
layout(early_fragment_tests) in;

#define EXPLICIT_GRADIENTS
#include "shared/bindings.h"
#ifdef INSERTION_SORTED
#include "lib/pixel_lock.glsl"
#else
#define SHARED_MEMORY
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
layout(rgba8_snorm, binding = IMG_2) SHARED_MEMORY writeonly uniform image2D frontNormal;
#endif
#if defined(SYNC_SPINLOCK) && defined(INSERTION_SORTED)
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
#ifdef FRONT_NORMAL
/// The geometric normal: that of a normal map would make the importance noisy.
vec3 frontNormalOfFragment() { return geometricNormal(); }
#endif
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
  bool wanted = there && !gl_HelperInvocation && (slots.capacity > 0u || slots.tail);
#ifndef TAIL_IN_SLOT  // which needs every colour
  wanted = wanted && !isRejected(p, slots, key);
#endif
  Fragment fragment;
  if (wanted) fragment = makeFragment(key, shadeTransparent());
  EXCLUSIVELY(p, wanted, insertIfNearer(p, slots, fragment))
#endif
}
