// Sorting of fragments in registers, and their composition: runs are sorted by a network and merged while
// they are composited. No array is indexed, so that a GPU keeps many threads in flight and a processor need
// not scatter. DEEP: pixels of more than SORT_BLOCK fragments keep their order, and nothing else, in an
// array. The idea of register-based block sort is of Knowles et al. 2014, "Fast Sorting for Exact OIT of
// Complex Scenes". For oit/resolve.comp, which declares where fragment i of the pixel is:
// uint slotOf(uint i).

struct Entry {
  uvec2 key;
  uint place;  // in its run
};

void sortTwo(inout Entry a, inout Entry b) {
  Entry first = a;
  bool swap = isNearer(b.key, a.key);
  a.key = swap ? b.key : a.key;
  a.place = swap ? b.place : a.place;
  b.key = swap ? first.key : b.key;
  b.place = swap ? first.place : b.place;
}

/// Of a fragment of the run, or, behind the last of `n`, farther than all.
Entry entryAt(uint begin, uint place, uint n) {
  return Entry(place < n ? keys[slotOf(begin + place)] : uvec2(NO_KEY), place);
}

/// @param begin number of the run's first fragment · @param n at most SORT_RUN
/// @param first becomes the nearest key of the run
/// @returns the places of the run's fragments, nearest first, four bits each from the lowest
uint sortRun(uint begin, uint n, out uvec2 first) {
  Entry a = entryAt(begin, 0u, n);
  Entry b = entryAt(begin, 1u, n);
  Entry c = entryAt(begin, 2u, n);
  Entry d = entryAt(begin, 3u, n);
  Entry e = entryAt(begin, 4u, n);
  Entry f = entryAt(begin, 5u, n);
  Entry g = entryAt(begin, 6u, n);
  Entry h = entryAt(begin, 7u, n);
  // Batcher's odd-even merge sort for 8 values, 19 comparisons (Knuth 1998, section 5.3.4).
  sortTwo(a, b); sortTwo(c, d); sortTwo(e, f); sortTwo(g, h);
  sortTwo(a, c); sortTwo(b, d); sortTwo(e, g); sortTwo(f, h);
  sortTwo(b, c); sortTwo(f, g);
  sortTwo(a, e); sortTwo(b, f); sortTwo(c, g); sortTwo(d, h);
  sortTwo(c, e); sortTwo(d, f);
  sortTwo(b, c); sortTwo(d, e); sortTwo(f, g);
  first = a.key;
  return a.place | b.place << 4 | c.place << 8 | d.place << 12 | e.place << 16 | f.place << 20 |
         g.place << 24 | h.place << 28;
}

/// Runs that are being merged, one to a component: the nearest fragment of each that is not taken yet,
/// and the places and number of those that are left.
struct Merge {
  uvec4 depths;
  uvec4 ids;
  uvec4 places;
  uvec4 left;
};

/// Of `n` fragments from `begin` on, at most SORT_BLOCK.
Merge sortedRuns(uint begin, uint n) {
  Merge m = Merge(uvec4(NO_KEY), uvec4(NO_KEY), uvec4(0u), uvec4(0u));
  for (uint run = 0u; run * SORT_RUN < n; ++run) {
    uvec2 first;
    m.places[run] = sortRun(begin + run * SORT_RUN, min(n - run * SORT_RUN, SORT_RUN), first);
    m.depths[run] = first.x;
    m.ids[run] = first.y;
    m.left[run] = min(n - run * SORT_RUN, SORT_RUN);
  }
  return m;
}

/// The component with the nearest fragment.
uint nearestRun(uvec4 depths, uvec4 ids) {
  uint run = 0u;
  uvec2 nearest = uvec2(depths.x, ids.x);
  for (uint other = 1u; other < SORT_RUNS; ++other) {
    uvec2 key = uvec2(depths[other], ids[other]);
    if (isNearer(key, nearest)) {
      nearest = key;
      run = other;
    }
  }
  return run;
}

/// Takes the nearest fragment out of runs that are not all empty. @returns its number
uint takeNearest(inout Merge m, uint begin) {
  uint run = nearestRun(m.depths, m.ids);
  uint first = begin + run * SORT_RUN;
  uint order = m.places[run];
  uint taken = first + (order & 15u);
  order >>= 4;
  uint more = m.left[run] - 1u;
  uvec2 next = more > 0u ? keys[slotOf(first + (order & 15u))] : uvec2(NO_KEY);
  m.places[run] = order;
  m.left[run] = more;
  m.depths[run] = next.x;
  m.ids[run] = next.y;
  return taken;
}

#ifndef DEEP
/// @param n at most SORT_BLOCK
void compositeRuns(inout Composite c, uint n) {
  Merge m = sortedRuns(0u, n);
  for (uint i = 0u; i < n; ++i) compositeUnder(c, slotOf(takeNearest(m, 0u)));
}
#else
/// Blocks of runs are merged into an array of numbers, and the blocks while they are composited.
/// @param n at most SORT_LARGE
void compositeBlocks(inout Composite c, uint n) {
  uint order[SORT_LARGE];
  uvec4 depths = uvec4(NO_KEY);
  uvec4 ids = uvec4(NO_KEY);
  uvec4 at = uvec4(0u);   // in the array
  for (uint block = 0u; block * SORT_BLOCK < n; ++block) {
    uint begin = block * SORT_BLOCK;
    uint size = min(n - begin, SORT_BLOCK);
    Merge m = sortedRuns(begin, size);
    for (uint i = 0u; i < size; ++i) order[begin + i] = takeNearest(m, begin);
    uvec2 first = keys[slotOf(order[begin])];
    depths[block] = first.x;
    ids[block] = first.y;
    at[block] = begin;
  }
  for (uint i = 0u; i < n; ++i) {
    uint block = nearestRun(depths, ids);
    compositeUnder(c, slotOf(order[at[block]]));
    uint next = at[block] + 1u;
    bool more = next < min((block + 1u) * SORT_BLOCK, n);
    uvec2 key = more ? keys[slotOf(order[min(next, SORT_LARGE - 1u)])] : uvec2(NO_KEY);
    at[block] = next;
    depths[block] = key.x;
    ids[block] = key.y;
  }
}
#endif
