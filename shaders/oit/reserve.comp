// Counts the covered pixels whose share of M - C slots rounds to no layer, Z of oit/allocate.comp,
// which reserves one layer for each of them.
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/frame.glsl"
#include "lib/oit.glsl"
#include "lib/budget.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(r32ui, binding = IMG_0) readonly uniform uimage2D importance;
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };

void main() {
  uint slots = frame.slots;
  if (slots < totals.covered) return;  // not one layer each: oit/allocate.comp selects pixels
  double total = double(totals.importanceHigh) * 4294967296.0lf + double(totals.importanceLow);
  uint least = slots - totals.covered;
  ivec2 first = ivec2(int(gl_GlobalInvocationID.x) * STRIP, int(gl_WorkGroupID.y));
  int end = min(first.x + STRIP, int(frame.size.x));
  uint starved = 0u;
  for (ivec2 p = first; p.x < end; ++p.x) {
    if (texelFetch(fragmentCount, p, 0).r == 0.0) continue;
    if (share(imageLoad(importance, p).r, least, total) == 0u) ++starved;
  }
  if (starved > 0u) atomicAdd(totals.starved, starved);
}
