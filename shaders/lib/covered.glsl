// Reads the lists that oit/covered.comp makes. Needs the buffer `totals`.
#include "shared/dispatch.h"

layout(std430, binding = SSBO_COVERED) readonly buffer Covered { uint covered[]; };

ivec2 placeOf(uint entry) { return ivec2(covered[entry] & 0xFFFFu, covered[entry] >> 16); }

/// The tile, of LISTED_TILE samples a side, of this thread. @return whether there is one
bool findCoveredTile(out ivec2 tile) {
  uint group = gl_WorkGroupID.y * ROW_GROUPS + gl_WorkGroupID.x;
  uint entry = group * uint(LIST_GROUP) + gl_LocalInvocationIndex;
  bool found = entry < totals.dispatches[LIST_OF_TILES].w;
  tile = found ? placeOf(entry) : ivec2(0);
  return found;
}
