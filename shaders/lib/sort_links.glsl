// Merge sort of a pixel's linked list in place (bottom-up, after Knuth 1998, section 5.2.4): no array,
// whatever the length, and n log n iterations, because llvmpipe ends a loop after 65,535 of them. For
// oit/resolve.comp.

bool isLinkNearer(uint a, uint b) { return isNearer(keys[a - 1u], keys[b - 1u]); }

/// @param head number of the first link plus one; 0: an empty list
/// @returns the head of the sorted list, nearest first
uint sortedLinks(uint head) {
  for (uint width = 1u;; width *= 2u) {
    uint left = head;
    uint tail = 0u;
    uint merges = 0u;
    head = 0u;
    while (left != 0u) {
      ++merges;
      uint right = left;
      uint leftSize = 0u;
      for (; leftSize < width && right != 0u; ++leftSize) right = links[right - 1u];
      uint rightSize = width;
      while (leftSize > 0u || (rightSize > 0u && right != 0u)) {
        bool takeLeft = leftSize > 0u && (rightSize == 0u || right == 0u || isLinkNearer(left, right));
        uint taken = takeLeft ? left : right;
        if (takeLeft) {
          left = links[left - 1u];
          --leftSize;
        } else {
          right = links[right - 1u];
          --rightSize;
        }
        if (tail == 0u) {
          head = taken;
        } else {
          links[tail - 1u] = taken;
        }
        tail = taken;
      }
      left = right;
    }
    if (tail != 0u) links[tail - 1u] = 0u;
    if (merges <= 1u) return head;
  }
}
