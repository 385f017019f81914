// Insertion among a pixel's nearest fragments. For oit/capture.frag, which declares the images.

#ifdef TAIL_IN_SLOT
void addToTail(uint slot, Fragment fragment) {
  storeTail(slot, loadTail(slot) + tailAddend(colorOf(fragment)));
}
#endif

/// Whether the slots are full of nearer fragments. Their last depth only ever comes nearer, so `true`
/// stays true, and the fragment need not be shaded; `false` holds only while no other fragment of the
/// pixel is stored.
bool isRejected(PixelSlots slots, uint fill, uvec2 key) {
  return fill == slots.capacity && (fill == 0u || isBehind(key, slots.first + fill - 1u));
}

/// Insertion sort by one element. Where the slots are full, the farthest fragment is evicted, into the
/// tail where there is one.
/// @param fill slots in use; isRejected() is false
void insertSorted(ivec2 p, PixelSlots slots, uint fill, Fragment fragment) {
  uint slot = fill;
  if (fill == slots.capacity) {
    slot = fill - 1u;
#ifdef TAIL_IN_SLOT
    if (slots.tail) addToTail(slots.first + slots.capacity, loadFragment(slots.first + slot));
#endif
  } else {
    imageStore(fragmentFill, p, uvec4(fill + 1u));
  }
  for (; slot > 0u; --slot) {
    Fragment other = loadFragment(slots.first + slot - 1u);
    if (!isNearer(fragment.key, other.key)) break;
    storeFragment(slots.first + slot, other);
  }
  storeFragment(slots.first + slot, fragment);
#ifdef FRONT_NORMAL
#ifdef TAIL_DYNAMIC
  // A fragment that may yet be merged into a tail is not the front one.
  bool isFront = slot == 0u && (slots.tail || slots.capacity > TAIL_SLOTS);
#else
  bool isFront = slot == 0u;
#endif
  if (isFront) {
    // The geometric normal: that of a normal map would make the importance noisy.
    imageStore(frontNormal, p, vec4(geometricNormalAt(materials[inIds.x]), 1.0));
  }
#endif
}

#ifdef TAIL_DYNAMIC
/// The last slots become a tail once more fragments came than there are slots; fragmentFill then
/// carries RANGE_TAIL.
void beginTail(ivec2 p, inout PixelSlots slots, inout uint fill) {
  if ((fill & RANGE_TAIL) == 0u) {
    if (fill < slots.capacity) return;
    vec4 sum = vec4(0.0);
    for (uint i = slots.capacity - TAIL_SLOTS; i < slots.capacity; ++i) {
      sum += tailAddend(colorOf(loadFragment(slots.first + i)));
    }
    storeTail(slots.first + slots.capacity - TAIL_SLOTS, sum);
    fill = (slots.capacity - TAIL_SLOTS) | RANGE_TAIL;
    imageStore(fragmentFill, p, uvec4(fill));
  }
  slots.capacity -= TAIL_SLOTS;
  slots.tail = true;
  fill &= ~RANGE_TAIL;
}
#endif

/// Reads the slots again, which other fragments may have changed meanwhile, and stores, merges or drops
/// the fragment.
void insertIfNearer(ivec2 p, PixelSlots slots, Fragment fragment) {
  uint fill = imageLoad(fragmentFill, p).r;
#ifdef TAIL_DYNAMIC
  beginTail(p, slots, fill);
#endif
  bool full = fill == slots.capacity;
  if (full && (fill == 0u || !isNearer(fragment.key, keys[slots.first + fill - 1u]))) {
#ifdef TAIL_IN_SLOT
    if (slots.tail) addToTail(slots.first + slots.capacity, fragment);
#endif
    return;
  }
  insertSorted(p, slots, fill, fragment);
}
