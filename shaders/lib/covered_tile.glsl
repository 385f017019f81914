// A thread's tile of the list of those that transparent fragments cover. Needs the buffer `totals`.
// LISTED_TILE: samples a side of a tile.
#include "shared/dispatch.h"

layout(std430, binding = SSBO_COVERED_TILES) readonly buffer CoveredTiles { uint coveredTiles[]; };

/// @return whether there is one
bool findCoveredTile(out ivec2 tile) {
  uint entry = (gl_WorkGroupID.y * ROW_GROUPS + gl_WorkGroupID.x) * uint(LIST_GROUP) + gl_LocalInvocationIndex;
  bool found = entry < totals.dispatches[0].w;
  uint place = found ? coveredTiles[entry] : 0u;
  tile = ivec2(place & 0xFFFFu, place >> 16);
  return found;
}
