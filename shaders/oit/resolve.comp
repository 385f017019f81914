// Composites the stored fragments of each pixel over the opaque image, nearest first.
// INSERTION_SORTED, INSERTION_ATOMIC: they are in order. INSERTION_APPEND: they are sorted here by
// (depth, id): those of pixels of up to SORT_BLOCK, with a list of tiles that have others; DEEP: the
// others, in these tiles. INSERTION_LINKED: so are the links of a list. INSERTION_ROUTED: they are the
// samples of a pixel. TAIL_IN_SLOT, TAIL_DENSE: the tail comes behind them.
#include "shared/dispatch.h"
layout(local_size_x = FULLSCREEN_GROUP, local_size_y = FULLSCREEN_GROUP) in;

#include "lib/frame.glsl"
#ifdef DEEP
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
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
/// Whether a tile is in the list, and from deepTileCount() on the list.
layout(std430, binding = SSBO_DEEP_TILES) buffer DeepTiles { uint deepTiles[]; };
#include "lib/list_dispatch.glsl"

ivec2 tilesOfImage() { return (ivec2(frame.size) + FULLSCREEN_GROUP - 1) / FULLSCREEN_GROUP; }
uint deepTileCount() { return uint(tilesOfImage().x * tilesOfImage().y); }

uint firstSlot;
uint slotOf(uint i) { return firstSlot + i; }
#include "lib/sort_runs.glsl"
#ifdef DEEP
#include "lib/sort_in_place.glsl"
#endif

void compositeStored(inout Composite c, ivec2 p, PixelSlots slots) {
  uint n = min(texelFetch(fragmentFill, p, 0).r, slots.capacity);
  firstSlot = slots.first;
#ifdef DEEP
  if (n <= SORT_BLOCK) return;
  if (n <= SORT_LARGE) {
    compositeBlocks(c, n);
  } else {
    compositeInPlace(c, slots.first, n);
  }
#else
  if (n > SORT_BLOCK) {
    ivec2 tile = p / FULLSCREEN_GROUP;
    uint mark = uint(tile.y * tilesOfImage().x + tile.x);
    if (atomicExchange(deepTiles[mark], 1u) != 0u) return;
    uint entry = atomicAdd(totals.dispatches[LIST_OF_DEEP].w, 1u);
    deepTiles[deepTileCount() + entry] = mark;
    atomicMax(totals.dispatches[LIST_OF_DEEP].z, 1u);
    growDispatch(LIST_OF_DEEP, entry + 1u);
    return;
  }
  compositeRuns(c, n);
#endif
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
#ifdef DEEP
  uint entry = gl_WorkGroupID.y * ROW_GROUPS + gl_WorkGroupID.x;
  if (entry >= totals.dispatches[LIST_OF_DEEP].w) return;
  int tile = int(deepTiles[deepTileCount() + entry]);
  ivec2 corner = ivec2(tile % tilesOfImage().x, tile / tilesOfImage().x) * FULLSCREEN_GROUP;
  ivec2 p = corner + ivec2(gl_LocalInvocationID.xy);
#else
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
#endif
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
