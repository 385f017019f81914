// Lists the tiles that transparent fragments cover. A thread walks a strip of tiles and adds to the
// list once. LISTED_TILE: samples a side of a tile.
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/frame.glsl"
#include "lib/oit.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
layout(std430, binding = SSBO_COVERED_TILES) writeonly buffer CoveredTiles { uint coveredTiles[]; };
#include "lib/list_dispatch.glsl"

bool isCovered(ivec2 tile) {
  ivec2 last = ivec2(frame.size.xy) - 1;
  float most = 0.0;
  for (int i = 0; i < LISTED_TILE * LISTED_TILE; ++i) {
    ivec2 p = tile * LISTED_TILE + ivec2(i % LISTED_TILE, i / LISTED_TILE);
    most = max(most, texelFetch(fragmentCount, min(p, last), 0).r);
  }
  return most > 0.0;
}

void main() {
  ivec2 first = ivec2(int(gl_GlobalInvocationID.x) * STRIP, int(gl_WorkGroupID.y));
  int end = min(STRIP, (int(frame.size.x) + LISTED_TILE - 1) / LISTED_TILE - first.x);
  uint covered = 0u;  // a bit for each tile of the strip
  for (int i = 0; i < end; ++i) {
    if (isCovered(first + ivec2(i, 0))) covered |= 1u << uint(i);
  }
  if (covered == 0u) return;
  uint entries = uint(bitCount(covered));
  uint place = atomicAdd(totals.dispatches[0].w, entries);
  atomicMax(totals.dispatches[0].z, 1u);
  growDispatch(0, (place + entries + uint(LIST_GROUP) - 1u) / uint(LIST_GROUP));
  for (int i = 0; i < end; ++i) {
    if ((covered & (1u << uint(i))) == 0u) continue;
    coveredTiles[place++] = uint(first.x + i) | uint(first.y) << 16;
  }
}
