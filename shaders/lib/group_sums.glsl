// What the threads of a work-group add up for the whole image. Needs GROUP_THREADS.
// GROUP_SUMS: in shared memory, so that one thread adds for its group. Else each thread adds by itself.
// All threads of a group must call these functions together.
#ifdef GROUP_SUMS
#include "lib/group_scan.glsl"

/// Whether this thread adds for its group.
bool addsForGroup() { return gl_LocalInvocationIndex == 0u; }

/// Sums over the group; of the components in `maxima`, the largest.
uvec4 groupTotal(uvec4 own, bvec4 maxima) {
  uint i = gl_LocalInvocationIndex;
  meetGroup();
  groupValues[i] = own;
  for (uint away = uint(GROUP_THREADS) / 2u; away > 0u; away /= 2u) {
    meetGroup();
    if (i < away) {
      uvec4 other = groupValues[i + away];
      own = mix(own + other, max(own, other), maxima);
      groupValues[i] = own;
    }
  }
  return own;  // of the thread that adds
}

/// Where a thread's items stand among those of its group.
struct GroupPlace {
  uint before;
  uint total;
};

GroupPlace placeInGroup(uint items) {
  uint upTo = sumUpTo(uvec4(items, 0u, 0u, 0u), uint(GROUP_THREADS)).x;
  return GroupPlace(upTo - items, sumOfAll(uint(GROUP_THREADS)).x);
}

/// What the thread that adds has got.
uint fromAdder(uint value) {
  meetGroup();
  if (addsForGroup()) groupValues[0].x = value;
  meetGroup();
  return groupValues[0].x;
}
#else
bool addsForGroup() { return true; }

uvec4 groupTotal(uvec4 own, bvec4 maxima) { return own; }

struct GroupPlace {
  uint before;
  uint total;
};

GroupPlace placeInGroup(uint items) { return GroupPlace(0u, items); }

uint fromAdder(uint value) { return value; }
#endif
