// How a work-group of a pass over the whole image takes its tile of TILE_WIDTH x TILE_HEIGHT places.
// GROUP_SUMS: neighbouring threads take neighbouring places, each a column of the tile, so that a fetch
// serves several of them; their sums meet in shared memory (lib/group_sums.glsl). Else each thread takes a
// strip and adds by itself: a processor runs the threads of a group after one another, some lanes at a
// time, and waiting for all of them took it two to five times as long.
#include "shared/dispatch.h"

#ifdef GROUP_SUMS
#define GROUP_THREADS TILE_WIDTH
const ivec2 kPlaceStep = ivec2(0, 1);
#else
#define GROUP_THREADS (TILE_WIDTH / STRIP * TILE_HEIGHT)
const ivec2 kPlaceStep = ivec2(1, 0);
#endif
#define THREAD_PLACES (TILE_WIDTH * TILE_HEIGHT / GROUP_THREADS)
layout(local_size_x = GROUP_THREADS) in;
#include "lib/group_sums.glsl"

/// The first place of this thread; the next is kPlaceStep farther.
ivec2 firstPlace() {
  ivec2 origin = ivec2(gl_WorkGroupID.xy) * ivec2(TILE_WIDTH, TILE_HEIGHT);
  uint thread = gl_LocalInvocationIndex;
#ifdef GROUP_SUMS
  return origin + ivec2(thread, 0u);
#else
  uint strips = uint(TILE_WIDTH / STRIP);
  return origin + ivec2(thread % strips * uint(STRIP), thread / strips);
#endif
}

/// How many places from the first on are within so many a side; THREAD_PLACES at the most.
int placesInside(ivec2 first, ivec2 size) {
  ivec2 left = clamp(size - first, ivec2(0), ivec2(THREAD_PLACES));
#ifdef GROUP_SUMS
  return left.x > 0 ? left.y : 0;
#else
  return left.y > 0 ? left.x : 0;
#endif
}
