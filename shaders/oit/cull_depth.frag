// The farthest depth that can still be among the k nearest: the first k occupied intervals hold at least
// k fragments (Vasilakis 2015, Lemma 2.1). Leaves the bit map empty for the next frame, which is cheaper
// than to clear all of it.
#include "lib/occupancy.glsl"

layout(binding = TEX_INPUT2) uniform sampler2D opaqueDepth;

/// Steps of the depth's bits by which the bound lies behind the interval's end: the float in
/// intervalOf() holds 24 of the 30 bits in which two depths can differ, so an end is up to 64 off, and
/// the division here as much again.
const uint kRounding = 256u;

void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(opaqueDepth, p, 0).r;
  gl_FragDepth = depth;
  uint k = slotsIfCrowded(p);
  if (k == 0u) return;
  uint first = firstWord(p);
  uint occupied = 0u;
  uint last = 32u * frame.occupancyWords;  // the interval in which the k-th bit stands
  for (uint i = 0u; i < frame.occupancyWords; ++i) {
    uint word = occupancy[first + i];
    if (word == 0u) continue;
    occupancy[first + i] = 0u;
    uint bits = uint(bitCount(word));
    if (occupied < k && occupied + bits >= k) {
      // Kernighan and Ritchie 1988: word & (word - 1) takes the lowest bit away.
      for (uint j = occupied + 1u; j < k; ++j) word &= word - 1u;
      last = 32u * i + uint(findLSB(word));
    }
    occupied += bits;
  }
  if (occupied < k) return;
  DepthIntervals d = intervalsAt(p);
  uint steps = uint(min(ceil(float(last + 1u) / d.perBit), 1073741824.0)) + kRounding;
  if (steps < d.nearest) gl_FragDepth = max(depth, uintBitsToFloat(d.nearest - steps));
}
