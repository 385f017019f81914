// Counts fragments and gathers features of the thesis's network, all by blending: the sum of their
// colours, the nearest and the farthest depth, the colour of the nearest (Tsopouridis 2021, section 4.2).
layout(early_fragment_tests) in;

#include "lib/oit.glsl"
#include "shared/network.h"
#include "lib/transparent.glsl"

layout(location = 0) out float count;      // summed
layout(location = 1) out vec2 range;       // maximum: reversed depth of the nearest, minus the farthest
layout(location = 2) out vec4 colorSum;    // summed
layout(location = 3) out vec4 nearest;     // maximum

void main() {
#ifdef HOLED
  if (!isThere()) discard;
#endif
  vec4 c = approximateTransparent();
  vec3 color = clamp(c.rgb, vec3(0.0), vec3(SLICE_MAX_COLOR));
  count = 1.0;
  range = vec2(gl_FragCoord.z, -gl_FragCoord.z);
  colorSum = vec4(round(color * FEATURE_COLOR_STEPS) / FEATURE_COLOR_STEPS, 0.0);
  // The nearest fragment's colour without a second pass: reversed depths are positive floats, whose
  // order hardly changes when eight bits of colour take the place of their last eight, so that the
  // maximum brings the colour along. Of equal depths the brighter channel wins.
  uint depth = floatBitsToUint(gl_FragCoord.z) & ~0xFFu;
  uvec3 eight = uvec3(min(color, vec3(1.0)) * 255.0 + 0.5);
  nearest = vec4(uintBitsToFloat(depth | eight.x), uintBitsToFloat(depth | eight.y),
                 uintBitsToFloat(depth | eight.z), 0.0);
}
