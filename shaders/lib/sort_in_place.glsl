// Sorting of a pixel's slots in place, however many. For oit/resolve.comp.

void swapSlots(uint a, uint b) {
  Fragment other = loadFragment(a);
  storeFragment(a, loadFragment(b));
  storeFragment(b, other);
}

/// Restores the heap of n slots (the farthest on top) below `node`.
void siftDown(uint begin, uint node, uint n) {
  for (uint child = 2u * node + 1u; child < n; child = 2u * node + 1u) {
    if (child + 1u < n && isNearer(keys[begin + child], keys[begin + child + 1u])) ++child;
    if (!isNearer(keys[begin + node], keys[begin + child])) return;
    swapSlots(begin + node, begin + child);
    node = child;
  }
}

/// Heap sort in place (Williams 1964): no array, and n log n iterations, because llvmpipe ends a loop
/// after 65,535 of them.
void compositeInPlace(inout Composite c, uint begin, uint n) {
  for (uint node = n / 2u; node > 0u; --node) siftDown(begin, node - 1u, n);
  for (uint last = n - 1u; last > 0u; --last) {
    swapSlots(begin, begin + last);
    siftDown(begin, 0u, last);
  }
  for (uint i = 0u; i < n; ++i) compositeUnder(c, begin + i);
}
