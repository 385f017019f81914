// Indirect dispatches over lists that grow. Needs the buffer `totals`.

/// Makes a list's dispatch large enough for so many work-groups.
void growDispatch(int list, uint groups) {
  atomicMax(totals.dispatches[list].x, min(groups, LOD_ROW_GROUPS));
  atomicMax(totals.dispatches[list].y, (groups + LOD_ROW_GROUPS - 1u) / LOD_ROW_GROUPS);
}
