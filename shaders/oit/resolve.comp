// Composites the stored fragments of each pixel over the opaque image, nearest first.
// INSERTION_SORTED, INSERTION_ATOMIC: they are in order. INSERTION_APPEND: they are sorted here by
// (depth, id). INSERTION_LINKED: so are the links of a list. INSERTION_ROUTED: they are the samples of a
// pixel. TAIL_IN_SLOT, TAIL_DENSE: the tail comes behind them.
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/frame.glsl"
#if defined(INSERTION_APPEND)
#define STORE_ACCESS
#else
#define STORE_ACCESS readonly
#define STORE_READONLY
#endif
#include "lib/oit.glsl"
#ifndef INSERTION_ROUTED
#include "lib/fragment_store.glsl"
#endif

#ifdef RANGES
layout(binding = TEX_INPUT0) uniform usampler2D fragmentRange;
#endif
#if !defined(INSERTION_ATOMIC) && !defined(INSERTION_ROUTED)
layout(binding = TEX_INPUT1) uniform usampler2D fragmentFill;
#endif
#ifdef TAIL_DENSE
layout(binding = TEX_INPUT2) uniform sampler2D tailSums;
#endif
#ifdef INSERTION_ROUTED
layout(binding = TEX_INPUT3) uniform usampler2DMS routedKeys;
layout(binding = TEX_INPUT4) uniform sampler2DMS routedColors;
#endif
layout(rgba16f, binding = IMG_0) uniform image2D hdrColor;
#ifdef INSERTION_LINKED
layout(std430, binding = SSBO_FRAGMENT_LINKS) buffer Links { uint links[]; };
#endif

struct Composite {
  vec3 color;
  float transmittance;
};

/// Front-to-back "over" (Porter and Duff 1984) of one premultiplied layer.
void compositeLayer(inout Composite c, vec4 layer) {
  c.color += c.transmittance * layer.rgb;
  c.transmittance *= 1.0 - layer.a;
}

#ifndef INSERTION_ROUTED
void compositeUnder(inout Composite c, uint slot) { compositeLayer(c, colorOf(loadFragment(slot))); }
#endif

#if defined(INSERTION_APPEND)
#include "lib/sort_append.glsl"
void compositeStored(inout Composite c, ivec2 p, PixelSlots slots) {
  uint n = min(texelFetch(fragmentFill, p, 0).r, slots.capacity);
  if (n <= SORT_SMALL) {
    compositeSmall(c, slots.first, n);
  } else if (n <= SORT_LARGE) {
    compositeLarge(c, slots.first, n);
  } else {
    compositeDeep(c, slots.first, n);
  }
}
#elif defined(INSERTION_LINKED)
#include "lib/sort_links.glsl"
void compositeStored(inout Composite c, ivec2 p, PixelSlots slots) {
  for (uint link = sortedLinks(texelFetch(fragmentFill, p, 0).r); link != 0u; link = links[link - 1u]) {
    compositeUnder(c, link - 1u);
  }
}
#elif defined(INSERTION_ATOMIC)
void compositeStored(inout Composite c, ivec2 p, PixelSlots slots) {
  for (uint i = 0u; i < slots.capacity && keys[slots.first + i].x != NO_KEY; ++i) {
    compositeUnder(c, slots.first + i);
  }
#ifdef TAIL_DENSE
  compositeLayer(c, tailLayer(texelFetch(tailSums, p, 0)));
#endif
}
#elif defined(INSERTION_ROUTED)
void compositeStored(inout Composite c, ivec2 p, PixelSlots slots) {
  uvec2 last = uvec2(0u);
  // As many rounds as slots, each taking the nearest behind the last: few slots, no array.
  for (uint round = 0u; round < slots.capacity; ++round) {
    uvec2 nearest = uvec2(NO_KEY);
    int at = -1;
    for (int i = 0; i < int(slots.capacity); ++i) {
      uvec2 key = texelFetch(routedKeys, p, i).rg;
      if (key.x != NO_KEY && isNearer(key, nearest) && (round == 0u || isNearer(last, key))) {
        nearest = key;
        at = i;
      }
    }
    if (at < 0) return;
    compositeLayer(c, texelFetch(routedColors, p, at));
    last = nearest;
  }
}
#else
void compositeStored(inout Composite c, ivec2 p, PixelSlots slots) {
  uint word = texelFetch(fragmentFill, p, 0).r;
#ifdef TAIL_DYNAMIC
  slots.tail = (word & RANGE_TAIL) != 0u;
#endif
  uint n = storedFragments(word, slots);
  for (uint i = 0u; i < n; ++i) compositeUnder(c, slots.first + i);
#ifdef TAIL_IN_SLOT
#ifndef TAIL_DYNAMIC
  n = slots.capacity;  // also where locks that were given up left slots empty
#endif
  if (slots.tail) compositeLayer(c, tailLayer(loadTail(slots.first + n)));
#endif
}
#endif

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (p.x >= int(frame.size.x) || p.y >= int(frame.size.y)) return;
#ifdef RANGES
  PixelSlots slots = slotsOf(texelFetch(fragmentRange, p, 0).rg);
  if (slots.capacity == 0u && !slots.tail) return;
#else
  PixelSlots slots = PixelSlots(uint(p.y * int(frame.size.x) + p.x) * frame.pixelSlots, frame.pixelSlots, false);
#endif
  Composite c = Composite(vec3(0.0), 1.0);
  compositeStored(c, p, slots);
  if (c.transmittance == 1.0 && c.color == vec3(0.0)) return;
  // Over the image, whose alpha is 1, or at a reduced rate over nothing.
  vec4 behind = imageLoad(hdrColor, p);
  imageStore(hdrColor, p, vec4(min(c.color + c.transmittance * behind.rgb, vec3(kMaxHalf)),
                               1.0 - c.transmittance * (1.0 - behind.a)));
}
