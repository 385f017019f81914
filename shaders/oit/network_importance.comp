// Importance of each pixel by the network's output, and its sum. FACTORS: also as a float,
// for heat maps.
#include "lib/tile.glsl"

#include "lib/frame.glsl"
#include "lib/oit.glsl"
#include "lib/network_output.glsl"

layout(binding = TEX_INPUT0) uniform sampler2D fragmentCount;
layout(r32ui, binding = IMG_0) writeonly uniform uimage2D importance;
#ifdef FACTORS
layout(rgba16f, binding = IMG_1) writeonly uniform image2D factors;
#endif
layout(std430, binding = SSBO_OIT_TOTALS) buffer Totals { OitTotals totals; };
#include "lib/importance_sum.glsl"

void main() {
  uint sum = 0u;
  uint covered = 0u;
  uint countMax = 0u;
  ivec2 p = firstPlace();
  int places = placesInside(p, ivec2(frame.size));
  for (int i = 0; i < places; ++i, p += kPlaceStep) {
    float count = texelFetch(fragmentCount, p, 0).r;
    if (count == 0.0) continue;
    float predicted = clamp(outputAt(p).low.x, 0.0, 1.0);
    uint value = uint(predicted * float(IMPORTANCE_ONE) + 0.5);
    sum += value;
    ++covered;
    countMax = max(countMax, uint(count));
    imageStore(importance, p, uvec4(value));
#ifdef FACTORS
    imageStore(factors, p, vec4(0.0, 0.0, 0.0, predicted));
#endif
  }
  addImportance(sum, covered, countMax);
}
