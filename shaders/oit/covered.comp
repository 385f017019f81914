// Lists the places that transparent fragments cover, so that later passes skip all others.
// LISTED_TILE: places are tiles of so many samples a side. SAMPLED: places are cells; one pixel of each
// is tested and listed.
#include "shared/oit_constants.h"
#include "lib/tile.glsl"

#include "lib/frame.glsl"
#include "lib/hash.glsl"
#include "lib/oit.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
layout(std430, binding = SSBO_COVERED) writeonly buffer Covered { uint covered[]; };
#include "lib/list_dispatch.glsl"

#ifdef SAMPLED
const int kList = LIST_OF_SAMPLES;
int placeSide() { return int(frame.sampledCellSide); }

/// A pixel of the cell, at a place that changes from cell to cell: a regular grid could coincide with a
/// pattern of the scene.
ivec2 entryOf(ivec2 cell) {
  int side = placeSide();
  uint h = hashPcg(uint(cell.x) + hashPcg(uint(cell.y)));
  ivec2 p = cell * side + ivec2(int(h >> 8) % side, int(h >> 20) % side);
  return min(p, ivec2(frame.size) - 1);
}

bool isCovered(ivec2 cell) { return texelFetch(fragmentCount, entryOf(cell), 0).r > 0.0; }
#else
const int kList = LIST_OF_TILES;
int placeSide() { return LISTED_TILE; }
ivec2 entryOf(ivec2 tile) { return tile; }

bool isCovered(ivec2 tile) {
  ivec2 last = ivec2(frame.size) - 1;
  float most = 0.0;
  for (int i = 0; i < LISTED_TILE * LISTED_TILE; ++i) {
    ivec2 p = tile * LISTED_TILE + ivec2(i % LISTED_TILE, i / LISTED_TILE);
    most = max(most, texelFetch(fragmentCount, min(p, last), 0).r);
  }
  return most > 0.0;
}
#endif

void main() {
  ivec2 first = firstPlace();
  int places = placesInside(first, (ivec2(frame.size) + placeSide() - 1) / placeSide());
  uint found = 0u;  // a bit for each place of the thread
  for (int i = 0; i < places; ++i) {
    if (isCovered(first + i * kPlaceStep)) found |= 1u << uint(i);
  }
  GroupPlace entries = placeInGroup(uint(bitCount(found)));
  uint at = 0u;
  if (addsForGroup() && entries.total > 0u) {
    at = atomicAdd(totals.dispatches[kList].w, entries.total);
#ifndef SAMPLED
    atomicMax(totals.dispatches[kList].z, 1u);
    growDispatch(kList, (at + entries.total + uint(LIST_GROUP) - 1u) / uint(LIST_GROUP));
#endif
  }
  at = fromAdder(at) + entries.before;
  for (int i = 0; found != 0u && i < places; ++i) {
    if ((found & (1u << uint(i))) == 0u) continue;
    ivec2 entry = entryOf(first + i * kPlaceStep);
    covered[at++] = uint(entry.x) | uint(entry.y) << 16;
  }
}
