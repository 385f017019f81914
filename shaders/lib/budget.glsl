// A pixel's share of the budget (Vasilakis 2017, Eq. 1: k_p = M I_p / sum I) in exact integer
// arithmetic, so that the sum of all k never exceeds the slots and no thread order changes a bit.

/// floor(importance * slots / total), corrected so that rounding in the division cannot show.
/// Products stay below 2^53, where doubles are exact: importance < 2^18, slots < 2^29.
uint share(uint importance, uint slots, double total) {
  if (total <= 0.0lf) return 0u;
  double wanted = double(importance) * double(slots);
  double k = floor(wanted / total);
  if (k * total > wanted) k -= 1.0lf;
  if ((k + 1.0lf) * total <= wanted) k += 1.0lf;
  return uint(min(k, double(MAX_PIXEL_LAYERS)));
}
