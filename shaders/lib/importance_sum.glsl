// Adds the importance of a thread's pixels to that of the image. Needs lib/group_sums.glsl and the buffer
// `totals`.

/// To be called by all threads of a group. @param covered pixels with a fragment
void addImportance(uint sum, uint covered, uint countMax) {
  uvec4 all = groupTotal(uvec4(sum, covered, countMax, 0u), bvec4(false, false, true, false));
  if (!addsForGroup() || all.y == 0u) return;
  uint old = atomicAdd(totals.importanceLow, all.x);
  if (old + all.x < old) atomicAdd(totals.importanceHigh, 1u);
  atomicAdd(totals.covered, all.y);
  atomicMax(totals.countMax, all.z);
}
