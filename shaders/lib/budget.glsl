// A pixel's share of the budget (Vasilakis 2017, Eq. 1: k_p = M I_p / sum I) in exact integer
// arithmetic, so that the sum of all k never exceeds the slots and no thread order changes a bit.
#include "lib/wide.glsl"

/// What is shared out. Importance, below 2^18, is a part of the total, below 2^44; slots are below 2^29.
struct Budget {
  uint slots;
  uvec2 total;
  float each;  // slots for one unit of importance, about
};

Budget budgetOf(uint slots, uvec2 total) {
  if (total == uvec2(0u)) total.x = 1u;  // no part of it has any importance either
  return Budget(slots, total, float(slots) / wideFloat(total));
}

/// floor(importance * slots / total), at most MAX_PIXEL_LAYERS; 0 where the total is 0.
uint share(uint importance, Budget b) {
  // Floats find it to 2^-20 of itself, so that it is off by one at the most. Signed integers convert
  // faster.
  int k = int(min(float(int(importance)) * b.each, float(MAX_PIXEL_LAYERS)));
  uvec2 wanted = wideProduct(importance, b.slots);
  uvec2 taken = wideProduct(uint(k), b.total.x) + uvec2(0u, uint(k) * b.total.y);
  uvec2 rest = wideDifference(wanted, taken);
  bool less = int(rest.y) < 0;
  bool more = !wideLess(rest, b.total) && k < int(MAX_PIXEL_LAYERS);
  return uint(k + (less ? -1 : more ? 1 : 0));
}

/// Whether that share is 0, without a division.
bool hasNoShare(uint importance, uint slots, uvec2 total) {
  return total == uvec2(0u) || wideLess(wideProduct(importance, slots), total);
}
