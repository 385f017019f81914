// Histogram of the pixels' numbers of fragments, for the one k of kb-plus (Vasilakis and Fudos 2014). A
// thread walks a strip and counts runs of equal n, so that even images cost few atomics.
#include "shared/oit_constants.h"
layout(local_size_x = STRIP_GROUP) in;

#include "lib/frame.glsl"
#include "lib/oit.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(std430, binding = SSBO_STRIP_SUMS) buffer Bins { uint bins[]; };

void countRun(uint n, uint pixels) {
  if (n > 0u) atomicAdd(bins[min(n, uint(COUNT_BINS)) - 1u], pixels);
}

void main() {
  ivec2 first = ivec2(int(gl_GlobalInvocationID.x) * STRIP, int(gl_WorkGroupID.y));
  int end = min(first.x + STRIP, int(frame.size.x));
  uint last = 0u;
  uint run = 0u;
  for (ivec2 p = first; p.x < end; ++p.x) {
    uint n = uint(texelFetch(fragmentCount, p, 0).r);
    if (n != last) {
      countRun(last, run);
      last = n;
      run = 0u;
    }
    ++run;
  }
  countRun(last, run);
}
