// Insertion among a pixel's nearest fragments. The includer declares the images and, FRONT_NORMAL,
// frontNormalOfFragment(). Compiled as C++ too (tests/model).
//
// fragmentFill holds the number of slots in use. Without a tail, once all of them are, it holds
// FILL_FULL and the farthest stored depth instead: one word, written last, which a test outside of
// the lock can read. SYNC_ORDERED has no lock, and may look at the slots themselves, which is faster.
// UNSAFE_PRETEST does so too, and writes the number first: for tests that must find this, because the
// farthest fragment may not have been written yet.

#if !defined(TAIL_IN_SLOT) && !defined(SYNC_ORDERED) && !defined(UNSAFE_PRETEST)
#define FARTHEST_IN_FILL
#endif

#ifdef TAIL_IN_SLOT
void addToTail(uint slot, Fragment fragment) {
  storeTail(slot, loadTail(slot) + tailAddend(colorOf(fragment)));
}
#endif

/// Whether a pixel's slots are full of nearer fragments, so that this one need not be shaded. Asked
/// without the lock: the word may be out of date, but the depth in it only ever comes nearer, so that
/// `true` stays true. Equal depths are told apart by insertIfNearer().
bool isRejected(ivec2 p, PixelSlots slots, uvec2 key) {
  uint word = imageLoad(fragmentFill, p).r;
  bool full = storedFragments(word, slots) == slots.capacity;
#ifdef FARTHEST_IN_FILL
  return full && depthRank(key) > (word & ~FILL_FULL);
#else
  return full && depthRank(key) > storedRank(loadFragment(slots.first + slots.capacity - 1u));
#endif
}

/// Insertion sort by one element. Where the slots are full, the farthest fragment is evicted, into the
/// tail where there is one.
/// @param fill slots in use
void insertSorted(ivec2 p, PixelSlots slots, uint fill, Fragment fragment) {
  bool full = fill == slots.capacity;
  uint last = full ? fill - 1u : fill;
#ifdef UNSAFE_PRETEST
  if (!full) imageStore(fragmentFill, p, uvec4(fill + 1u));
#endif
#ifdef TAIL_IN_SLOT
  if (full && slots.tail) {
    addToTail(slots.first + slots.capacity, loadFragment(slots.first + last));
  }
#endif
#ifdef FARTHEST_IN_FILL
  uint farthest = storedRank(fragment);
#endif
  uint slot = last;
  for (; slot > 0u; --slot) {
    Fragment other = loadFragment(slots.first + slot - 1u);
    if (!isNearer(fragment.key, other.key)) break;
#ifdef FARTHEST_IN_FILL
    if (slot == last) farthest = storedRank(other);
#endif
    storeFragment(slots.first + slot, other);
  }
  storeFragment(slots.first + slot, fragment);
#ifdef FARTHEST_IN_FILL
  uint word = last + 1u == slots.capacity ? FILL_FULL | farthest : fill + 1u;
  imageStore(fragmentFill, p, uvec4(word));
#elif !defined(UNSAFE_PRETEST)
  if (!full) imageStore(fragmentFill, p, uvec4(fill + 1u));
#endif
#ifdef FRONT_NORMAL
#ifdef TAIL_DYNAMIC
  // A fragment that may yet be merged into a tail is not the front one.
  bool isFront = slot == 0u && (slots.tail || slots.capacity > TAIL_SLOTS);
#else
  bool isFront = slot == 0u;
#endif
  if (isFront) imageStore(frontNormal, p, vec4(frontNormalOfFragment(), 1.0));
#endif
}

#ifdef TAIL_DYNAMIC
/// The last slots become a tail once more fragments came than there are slots; fragmentFill then
/// carries RANGE_TAIL.
void beginTail(ivec2 p, INOUT(PixelSlots) slots, INOUT(uint) word) {
  if ((word & RANGE_TAIL) == 0u) {
    if (word < slots.capacity) return;
    vec4 sum = vec4(0.0);
    for (uint i = slots.capacity - TAIL_SLOTS; i < slots.capacity; ++i) {
      sum += tailAddend(colorOf(loadFragment(slots.first + i)));
    }
    storeTail(slots.first + slots.capacity - TAIL_SLOTS, sum);
    word = (slots.capacity - TAIL_SLOTS) | RANGE_TAIL;
    imageStore(fragmentFill, p, uvec4(word));
  }
  slots.capacity -= TAIL_SLOTS;
  slots.tail = true;
}
#endif

/// Reads the slots, which other fragments may have changed since isRejected(), and stores, merges or
/// drops the fragment. Called by one invocation of a pixel at a time.
void insertIfNearer(ivec2 p, PixelSlots slots, Fragment fragment) {
  uint word = imageLoad(fragmentFill, p).r;
#ifdef TAIL_DYNAMIC
  beginTail(p, slots, word);
#endif
  uint fill = storedFragments(word, slots);
  bool full = fill == slots.capacity;
  if (full && (fill == 0u || !isNearer(fragment.key, loadFragment(slots.first + fill - 1u).key))) {
#ifdef TAIL_IN_SLOT
    if (slots.tail) addToTail(slots.first + slots.capacity, fragment);
#endif
    return;
  }
  insertSorted(p, slots, fill, fragment);
}
