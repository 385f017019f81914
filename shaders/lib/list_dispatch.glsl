// Indirect dispatches over lists that grow. Needs the buffer `totals`, whose `dispatches` hold the
// work-groups of each list in x, y and z, as glDispatchComputeIndirect takes them, and in w its entries.
#include "shared/dispatch.h"

/// Makes a list's dispatch large enough for so many work-groups.
void growDispatch(int list, uint groups) {
  atomicMax(totals.dispatches[list].x, min(groups, ROW_GROUPS));
  atomicMax(totals.dispatches[list].y, (groups + ROW_GROUPS - 1u) / ROW_GROUPS);
}
