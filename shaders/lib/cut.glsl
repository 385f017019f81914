// Where the budget M lies among the five amounts of oit/share.comp, and parts of what the next larger one
// adds, in exact integer arithmetic.
#include "lib/wide.glsl"

/// Amount of a number: 0 is nothing, 1 .. 4 are those of `amounts`, at least 0 and ascending.
uint amountOf(uvec4 amounts, uint number) { return number == 0u ? 0u : amounts[number - 1u]; }

/// floor(a 2^32 / b), where a < b, and what remains.
uint fraction(inout uint a, uint b) {
  uint quotient = 0u;
  for (int bit = 0; bit < 32; ++bit) {
    bool carried = a >= 1u << 31;
    a <<= 1;
    quotient <<= 1;
    if (carried || a >= b) {
      a -= b;
      quotient |= 1u;
    }
  }
  return quotient;
}

/// a / b in steps of 2^-64, rounded up, where a < b.
uvec2 ratioOf(uint a, uint b) {
  uint high = fraction(a, b);
  uint low = fraction(a, b);
  return wideSum(uvec2(low, high), uvec2(a > 0u ? 1u : 0u, 0u));
}

/// x: number of the largest amount A within the slots; y, z: (M - A) / (B - A), B being the next one; 0
/// where there is none.
uvec4 cutOf(uvec4 amounts, uint slots) {
  uint number = 0u;
  while (number < 4u && amounts[number] <= slots) ++number;
  if (number == 4u) return uvec4(4u, 0u, 0u, 0u);
  uint base = amountOf(amounts, number);
  return uvec4(number, ratioOf(slots - base, amounts[number] - base), 0u);
}

/// floor(sum (M - A) / (B - A)) for a sum up to B - A. Exact: rounding the ratio up adds less than
/// 2^-32, and the quotient's fraction is a multiple of 1 / (B - A), which is more.
uint granted(uint sum, uvec2 ratio) {
  return wideSum(wideProduct(sum, ratio.y), uvec2(wideProduct(sum, ratio.x).y, 0u)).y;
}
