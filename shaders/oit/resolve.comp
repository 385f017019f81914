// Composites the stored fragments of each pixel over the opaque image, nearest first.
// SORTED: the ranges are in order. Otherwise they are sorted here by (depth, id).
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/frame.glsl"
#include "lib/oit.glsl"

layout(binding = TEX_INPUT0) uniform usampler2D fragmentRange;
layout(binding = TEX_INPUT1) uniform usampler2D fragmentFill;
layout(rgba16f, binding = IMG_0) uniform image2D hdrColor;
#ifdef SORTED
#define SORTED_IN_PLACE readonly
#else
#define SORTED_IN_PLACE
#endif
layout(std430, binding = SSBO_FRAGMENT_KEYS) SORTED_IN_PLACE buffer Keys { uvec2 keys[]; };
layout(std430, binding = SSBO_FRAGMENT_COLORS) SORTED_IN_PLACE buffer Colors { uvec2 colors[]; };

struct Composite {
  vec3 color;
  float transmittance;
};

/// Front-to-back "over" (Porter and Duff 1984) of one premultiplied fragment.
void compositeUnder(inout Composite c, uint slot) {
  vec4 fragment = unpackColor(colors[slot]);
  c.color += c.transmittance * fragment.rgb;
  c.transmittance *= 1.0 - fragment.a;
}

#ifndef SORTED
/// Insertion sort of (key, slot) in a local array of SIZE entries. A small array for most pixels:
/// the size of local arrays bounds how many threads a GPU keeps in flight (Lefebvre et al. 2014).
#define DEFINE_SORT(NAME, SIZE)                                        \
  void NAME(inout Composite c, uint begin, uint n) {                   \
    uvec2 sortedKeys[SIZE];                                            \
    uint slots[SIZE];                                                  \
    for (uint i = 0u; i < n; ++i) {                                    \
      uvec2 key = keys[begin + i];                                     \
      uint j = i;                                                      \
      for (; j > 0u && isNearer(key, sortedKeys[j - 1u]); --j) {       \
        sortedKeys[j] = sortedKeys[j - 1u];                            \
        slots[j] = slots[j - 1u];                                      \
      }                                                                \
      sortedKeys[j] = key;                                             \
      slots[j] = begin + i;                                            \
    }                                                                  \
    for (uint i = 0u; i < n; ++i) compositeUnder(c, slots[i]);         \
  }
DEFINE_SORT(compositeSmall, SORT_SMALL)
DEFINE_SORT(compositeLarge, SORT_LARGE)

void swapSlots(uint a, uint b) {
  uvec2 key = keys[a];
  uvec2 color = colors[a];
  keys[a] = keys[b];
  colors[a] = colors[b];
  keys[b] = key;
  colors[b] = color;
}

/// Restores the heap of n slots (the farthest on top) below `node`.
void siftDown(uint begin, uint node, uint n) {
  for (uint child = 2u * node + 1u; child < n; child = 2u * node + 1u) {
    if (child + 1u < n && isNearer(keys[begin + child], keys[begin + child + 1u])) ++child;
    if (!isNearer(keys[begin + node], keys[begin + child])) return;
    swapSlots(begin + node, begin + child);
    node = child;
  }
}

/// Heap sort in place (Williams 1964): no array, and n log n steps, because a software rasteriser
/// ends a shader's loops after 65,535 of them.
void compositeDeep(inout Composite c, uint begin, uint n) {
  for (uint node = n / 2u; node > 0u; --node) siftDown(begin, node - 1u, n);
  for (uint last = n - 1u; last > 0u; --last) {
    swapSlots(begin, begin + last);
    siftDown(begin, 0u, last);
  }
  for (uint i = 0u; i < n; ++i) compositeUnder(c, begin + i);
}
#endif

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (p.x >= int(frame.size.x) || p.y >= int(frame.size.y)) return;
  uvec2 range = texelFetch(fragmentRange, p, 0).rg;
  if (range.y == 0u) return;
  uint n = min(texelFetch(fragmentFill, p, 0).r, range.y);
  Composite c = Composite(vec3(0.0), 1.0);
#ifdef SORTED
  for (uint i = 0u; i < n; ++i) compositeUnder(c, range.x + i);
#else
  if (n <= SORT_SMALL) {
    compositeSmall(c, range.x, n);
  } else if (n <= SORT_LARGE) {
    compositeLarge(c, range.x, n);
  } else {
    compositeDeep(c, range.x, n);
  }
#endif
  vec3 behind = imageLoad(hdrColor, p).rgb;
  imageStore(hdrColor, p, vec4(c.color + c.transmittance * behind, 1.0));
}
