// Histogram of the pixels' numbers of fragments, for the one k of kb-plus (Vasilakis and Fudos 2014). A
// thread counts runs of equal n, so that even images cost few atomics. GROUP_SUMS: first in shared memory.
#include "lib/tile.glsl"

#include "lib/frame.glsl"
#include "lib/oit.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(std430, binding = SSBO_STRIP_SUMS) buffer Bins { uint bins[]; };

#ifdef GROUP_SUMS
shared uint groupBins[COUNT_BINS];
#endif

void countRun(uint n, uint pixels) {
  if (n == 0u) return;
#ifdef GROUP_SUMS
  atomicAdd(groupBins[min(n, uint(COUNT_BINS)) - 1u], pixels);
#else
  atomicAdd(bins[min(n, uint(COUNT_BINS)) - 1u], pixels);
#endif
}

void main() {
#ifdef GROUP_SUMS
  for (uint i = gl_LocalInvocationIndex; i < uint(COUNT_BINS); i += uint(GROUP_THREADS)) groupBins[i] = 0u;
  meetGroup();
#endif
  uint last = 0u;
  uint run = 0u;
  ivec2 p = firstPlace();
  int places = placesInside(p, ivec2(frame.size));
  for (int i = 0; i < places; ++i, p += kPlaceStep) {
    uint n = uint(texelFetch(fragmentCount, p, 0).r);
    if (n != last) {
      countRun(last, run);
      last = n;
      run = 0u;
    }
    ++run;
  }
  countRun(last, run);
#ifdef GROUP_SUMS
  meetGroup();
  for (uint i = gl_LocalInvocationIndex; i < uint(COUNT_BINS); i += uint(GROUP_THREADS)) {
    if (groupBins[i] > 0u) atomicAdd(bins[i], groupBins[i]);
  }
#endif
}
