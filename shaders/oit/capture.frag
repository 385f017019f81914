// Stores transparent fragments in their pixel's range.
// INSERTION_APPEND: in any order, sorted at the resolve. INSERTION_SORTED: the k nearest, in order.
// SYNC_ORDERED: the rasteriser draws a pixel's fragments in order on one thread. SYNC_INTERLOCK,
// SYNC_SPINLOCK: critical sections. SYNC_NONE: hazards on purpose.
#if defined(SYNC_INTERLOCK) && defined(INSERTION_SORTED)
layout(pixel_interlock_ordered) in;
#endif
layout(early_fragment_tests) in;

#define EXPLICIT_GRADIENTS
#include "lib/oit.glsl"
#include "lib/transparent.glsl"

#if defined(SYNC_ORDERED) || defined(SYNC_NONE)
#define SHARED_MEMORY
#else
#define SHARED_MEMORY coherent
#endif

layout(rg32ui, binding = IMG_0) readonly uniform uimage2D fragmentRange;
layout(r32ui, binding = IMG_1) SHARED_MEMORY uniform uimage2D fragmentFill;
#ifdef FRONT_NORMAL
layout(rgba8_snorm, binding = IMG_2) writeonly uniform image2D frontNormal;
#endif
#ifdef SYNC_SPINLOCK
layout(r32ui, binding = IMG_3) coherent uniform uimage2D fragmentLock;
#endif
layout(std430, binding = SSBO_FRAGMENT_KEYS) SHARED_MEMORY buffer Keys { uvec2 keys[]; };
layout(std430, binding = SSBO_FRAGMENT_COLORS) SHARED_MEMORY buffer Colors { uvec2 colors[]; };
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };

#ifdef INSERTION_SORTED
/// Insertion sort by one element; the farthest falls out where the range is full.
/// @param fill slots in use, known not to be full of nearer fragments
void insertSorted(ivec2 p, uvec2 range, uint fill, uvec2 key, uvec2 color) {
  uint slot = fill;
  if (fill == range.y) {
    slot = fill - 1u;
  } else {
    imageStore(fragmentFill, p, uvec4(fill + 1u));
  }
  for (; slot > 0u; --slot) {
    uvec2 other = keys[range.x + slot - 1u];
    if (!isNearer(key, other)) break;
    keys[range.x + slot] = other;
    colors[range.x + slot] = colors[range.x + slot - 1u];
  }
  keys[range.x + slot] = key;
  colors[range.x + slot] = color;
#ifdef FRONT_NORMAL
  if (slot == 0u) {
    // The geometric normal: one of a normal map would make the importance speckle.
    vec3 n = dot(inNormal, inNormal) > 0.0 ? normalize(inNormal) : vec3(0.0, 1.0, 0.0);
    imageStore(frontNormal, p, vec4(n * facing(materials[inIds.x]), 1.0));
  }
#endif
}

/// Whether the range is full of nearer fragments. Its last depth only ever comes nearer, so an
/// answer of yes stays true, and the fragment need not be shaded; no holds only while nobody else
/// writes.
bool isRejected(uvec2 range, uint fill, uvec2 key) {
  return fill == range.y && !isNearer(key, keys[range.x + range.y - 1u]);
}

/// For critical sections: looks again at what others may have stored meanwhile.
void insertIfNearer(ivec2 p, uvec2 range, uvec2 key, uvec2 color) {
  uint fill = imageLoad(fragmentFill, p).r;
  if (!isRejected(range, fill, key)) insertSorted(p, range, fill, key, color);
}
#endif

void main() {
#ifdef TEXTURED
  prepareGradients();
#endif
  ivec2 p = ivec2(gl_FragCoord.xy);
  uvec2 range = imageLoad(fragmentRange, p).rg;
  uvec2 key = fragmentKey(gl_FragCoord.z, fragmentId());
  // No early return: the interlock must begin outside of all branches.
  bool wanted = range.y > 0u;
#ifdef INSERTION_SORTED
  uint fill = 0u;
  if (wanted) {
    fill = imageLoad(fragmentFill, p).r;
    wanted = !isRejected(range, fill, key);
  }
#endif
  uvec2 color = uvec2(0u);
  if (wanted) color = packColor(shadeTransparent());

#if !defined(INSERTION_SORTED)
  if (!wanted) return;
#ifdef SYNC_ORDERED
  uint slot = imageLoad(fragmentFill, p).r;
  imageStore(fragmentFill, p, uvec4(slot + 1u));
#else
  uint slot = imageAtomicAdd(fragmentFill, p, 1u);
#endif
  if (slot >= range.y) return;  // beyond the pool: counted, the frame is flagged inexact
  keys[range.x + slot] = key;
  colors[range.x + slot] = color;
#elif defined(SYNC_INTERLOCK)
  beginInvocationInterlockARB();
  if (wanted) insertIfNearer(p, range, key, color);
  endInvocationInterlockARB();
#elif defined(SYNC_SPINLOCK)
  bool done = !wanted || gl_HelperInvocation;  // helpers write nothing and must not wait
  for (int i = 0; i < LOCK_BOUND && !done; ++i) {
    if (imageAtomicExchange(fragmentLock, p, 1u) != 0u) continue;
    insertIfNearer(p, range, key, color);
    memoryBarrier();
    imageAtomicExchange(fragmentLock, p, 0u);
    done = true;
  }
  if (!done) atomicAdd(totals.lockFailures, 1u);
#else
  if (wanted) insertSorted(p, range, fill, key, color);
#endif
}
