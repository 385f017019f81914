// Shares all slots of the budget out: between the two amounts next to it - nothing, the least that
// each pixel needs, what it takes at the high price, at the low one, all its fragments - every pixel
// gets its part of what the larger amount adds, in one even sequence over the image. Sums are exact, so
// the slots given are those of the budget, and places follow without a counter.
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/frame.glsl"
#include "lib/hand_out.glsl"
#include "lib/strips.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(r32ui, binding = IMG_2) readonly uniform uimage2D slotBids;
layout(std430, binding = SSBO_OIT_TOTALS) readonly buffer Totals { OitTotals totals; };
layout(std430, binding = SSBO_STRIP_SUMS) readonly buffer StripSums { uvec4 stripSums[]; };

/// Of `extra` slots that all would like, those that the first `wanted` get when `granted` are there.
/// The offset keeps floor() from falling below a whole number that rounding has just missed; it is
/// smaller than any step of the quotient that matters and larger than the error of the product.
uint granted(uint wanted, double ratio) { return uint(floor(double(wanted) * ratio + 2.4e-7lf)); }

uint levelOf(uvec4 levels, int level) { return level < 0 ? 0u : levels[level]; }

void main() {
  ivec2 first = ivec2(int(gl_GlobalInvocationID.x) * STRIP, int(gl_WorkGroupID.y));
  if (first.x >= int(frame.size.x)) return;
  int end = min(first.x + STRIP, int(frame.size.x));
  uint slots = min(frame.oit.y, totals.levels.w);
  int lower = -1;
  while (lower < 3 && totals.levels[lower + 1] <= slots) ++lower;
  uint base = levelOf(totals.levels, lower);
  uint extra = lower < 3 ? totals.levels[lower + 1] - base : 0u;
  double ratio = extra > 0u ? double(slots - base) / double(extra) : 0.0lf;

  uvec4 before = stripSums[stripIndex(first)] + stripSums[rowIndex(uint(first.y))];
  uint given = levelOf(before, lower);
  uint wanted = lower < 3 ? before[lower + 1] - given : 0u;
  uint from = granted(wanted, ratio);
  for (ivec2 p = first; p.x < end; ++p.x) {
    uint n = min(uint(texelFetch(fragmentCount, p, 0).r), MAX_PIXEL_LAYERS);
    uint k = 0u;
    if (n > 0u) {
      uvec4 amounts = uvec4(min(n, LEAST_SLOTS), unpackTaken(imageLoad(slotBids, p).r), n);
      uint own = levelOf(amounts, lower);
      uint more = lower < 3 ? amounts[lower + 1] - own : 0u;
      wanted += more;
      uint to = granted(wanted, ratio);
      k = own + to - from;
      handOut(p, n, given + from, k);
      given += own;
      from = to;
    }
  }
}
